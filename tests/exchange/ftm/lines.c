/* Each line of a small ship, bent: what is said of it, and what is read. */
#include "exchange/listed.h"

/* One layer, four points, two edges, one curve, two faces; lines from 1 on. */
static const char *const ship[] = {
    "FREE!ship", "2.6", "1",   "1",                                                  /* 4 */
    "Side",      "3",   "255", "1", "1",       "1", "1", "1", "0",  "0", "1", "171", /* 16 */
    "0",         "4",                                                                /* 18 */
    "0 0 0",     "1",   "0",   "0", "1 0 0",   "1", "0", "0",                        /* 26 */
    "1 1 0",     "1",   "0",   "0", "0 1 0.5", "1", "0", "0",                        /* 34 */
    "2",         "0",   "1",   "1", "7",       "1", "3", "0", "-7",                  /* 43 */
    "1",         "2",   "0",   "3", "9",                                             /* 48 */
    "2",         "3",   "0",   "1", "2",       "0", "5", "4", "0",  "1", "2", "3",
    "0",         "5"}; /* 62 */

/* The ship with one line in place of another, up to `count` lines. */
static char *ship_with(int line, const char *instead, int count)
{
    char *text = test_array(2000, 1), *at = text;
    for (int i = 0; i < count; i++)
        at += sprintf(at, "%s\n", i + 1 == line ? instead : ship[i]);
    return text;
}

#define NET "the control net is read; the subdivision surface that it stands for, with "
#define REST                                                              \
    "~0: faces of more than three corners: 1; read as triangles\n0: " NET \
    "1 crease and 1 curve, is not made\n~0: face of the control net: 2 read\n"

TEST(each_line_of_a_ship_that_is_bent_is_named_with_what_it_should_be)
{
    static const struct {
        int line;
        const char *instead, *listing;
    } cases[] = {
        {27, "1 1", "t:27: point 3 does not have three coordinates\n"},
        {27, "1 1 1 1", "t:27: point 3 does not have three coordinates\n"},
        {27, "1 x 1", "t:27: point 3 does not have three coordinates\n"},
        {35, "8", "t:35: the number of edges is not a whole number from 0 to 7\n"},
        {35, "-1", "t:35: the number of edges is not a whole number from 0 to 7\n"},
        {36, "4", "t:36: an end of an edge is not a whole number from 0 to 3\n"},
        {37, "-1", "t:37: an end of an edge is not a whole number from 0 to 3\n"},
        {38, "2", "t:38: the mark of a crease is not a whole number from 0 to 1\n"},
        {39, "x",
         "t:39: a mark of an edge is not a whole number from -2147483648 to 2147483647\n"},
        {43, "1 1",
         "t:43: a mark of an edge is not a whole number from -2147483648 to 2147483647\n"},
        {44, "7", "t:44: the number of curves is not a whole number from 0 to 6\n"},
        {45, "19",
         "t:45: the number of points of a curve is not a whole number from 0 to 18\n"},
        {46, "4", "t:46: a point of a curve is not a whole number from 0 to 3\n"},
        {47, "-1", "t:47: a point of a curve is not a whole number from 0 to 3\n"},
        {48, "",
         "t:48: a mark of a curve is not a whole number from -2147483648 to 2147483647\n"},
        {49, "3", "t:49: the number of faces is not a whole number from 0 to 2\n"},
        {50, "2",
         "t:50: the number of corners of a face is not a whole number from 3 to 100\n"},
        {50, "101",
         "t:50: the number of corners of a face is not a whole number from 3 to 100\n"},
        {52, "4", "t:52: a corner of a face is not a whole number from 0 to 3\n"},
        {54, "1", "t:54: the layer of a face is not a whole number from 0 to 0\n"},
        {55, "five",
         "t:55: a mark of a face is not a whole number from -2147483648 to 2147483647\n"},
        {61, "-1", "t:61: the layer of a face is not a whole number from 0 to 0\n"}};
    for (int i = 0; i < COUNT(cases); i++)
        check_listed(ship_with(cases[i].line, cases[i].instead, COUNT(ship)), BATTEN_FORMAT_FTM,
                     BATTEN_BAD_FORMAT, cases[i].listing);
}

TEST(lines_of_a_ship_at_their_bounds_are_read)
{
    static const struct {
        int line;
        const char *instead;
    } cases[] = {{35, "2"}, {36, "3"}, {37, "0"},    {39, "-2147483648"}, {39, "2147483647"},
                 {46, "3"}, {47, "0"}, {48, " -5 "}, {55, "2147483647"}};
    for (int i = 0; i < COUNT(cases); i++)
        check_listed(ship_with(cases[i].line, cases[i].instead, COUNT(ship)), BATTEN_FORMAT_FTM,
                     BATTEN_OK, REST);
}

TEST(a_ship_without_its_last_line_is_refused_at_it)
{
    check_listed(ship_with(0, "", COUNT(ship) - 1), BATTEN_FORMAT_FTM, BATTEN_BAD_FORMAT,
                 "t:62: a mark of a face is not a whole number from -2147483648 to "
                 "2147483647\n");
}

TEST(faces_of_a_ship_are_fans_of_their_corners_in_their_order)
{
    static const double due[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5};
    static const int corners[] = {0, 1, 2, 0, 1, 2, 0, 2, 3};
    batten_model *model =
        read_listed(ship_with(0, "", COUNT(ship)), strlen(ship_with(0, "", COUNT(ship))),
                    BATTEN_FORMAT_FTM, BATTEN_OK, REST);
    const batten_object *object = batten_model_object(model, 0);
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_TEXT(object->name, "Side");
    CHECK_TEXT(object->layer, "Side");
    CHECK_INT(p->triangle_count, 3);
    CHECK_INT(p->vertex_count, 4);
    for (int i = 0; i < 9; i++)
        CHECK_INT(p->corners[i], corners[i]);
    for (int i = 0; i < 12; i++)
        CHECK_BITS(p->points[i], due[i]);
    batten_model_unref(model);
}

TEST(the_look_of_a_layer_is_its_name_and_a_colour_with_blue_in_the_third_byte)
{
    static const struct {
        int line;
        const char *instead, *name;
        bool has_colour;
        int rgb[3];
        const char *listing;
    } cases[] = {
        {7, "0", "Side", true, {0, 0, 0}, REST},
        {7, "16777215", "Side", true, {255, 255, 255}, REST},
        {7, "66051", "Side", true, {3, 2, 1}, REST},
        {7,
         "16777216",
         "Side",
         false,
         {0},
         "0: Side: the colour of the layer is not a whole number from 0 to 16777215; it has none\n" REST},
        {7,
         "-1",
         "Side",
         false,
         {0},
         "0: Side: the colour of the layer is not a whole number from 0 to 16777215; it has none\n" REST},
        {5, "", "layer 1", true, {255, 0, 0}, REST},
        {4, "x", "layer 1", false, {0}, REST} /* no layers are found */};
    for (int i = 0; i < COUNT(cases); i++) {
        const char *text = ship_with(cases[i].line, cases[i].instead, COUNT(ship));
        batten_model *model =
            read_listed(text, strlen(text), BATTEN_FORMAT_FTM, BATTEN_OK, cases[i].listing);
        const batten_object *object = batten_model_object(model, 0);
        CHECK_TEXT(object->name, cases[i].name);
        CHECK_INT(object->has_colour, cases[i].has_colour);
        for (int k = 0; k < 3 && cases[i].has_colour; k++)
            CHECK_BITS(object->colour[k], cases[i].rgb[k] / 255.0);
        batten_model_unref(model);
    }
}

TEST(a_coordinate_too_small_for_a_double_is_noted_at_its_line)
{
    check_listed(ship_with(31, "0 1e-999 0.5", COUNT(ship)), BATTEN_FORMAT_FTM, BATTEN_OK,
                 "31: the number 1e-999 is too small for a double; read as 0\n" REST);
}

TEST(points_of_a_ship_are_limited)
{
    batten_read_options options = batten_read_defaults();
    batten_limits limits = batten_limits_defaults();
    batten_model *model = NULL;
    const char *text = ship_with(0, "", COUNT(ship));
    options.limits = &limits;
    options.format = BATTEN_FORMAT_FTM;
    limits.points = 3;
    CHECK_STATUS(batten_read_memory(text, strlen(text), &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("line 18: 4 points; the limit is 3");
    limits.points = 4;
    CHECK_OK(batten_read_memory(text, strlen(text), &options, NULL, NULL, &model));
    batten_model_unref(model);
}
