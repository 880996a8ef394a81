#include "exchange/iges/read/reading.h"
#include "exchange/iges/text.h"

#include <batten/measure.h>

static void check_left_out(int type, const char *parameters, const char *words)
{
    iges_text file = iges_begin();
    iges_add(&file, type, 0, 0, 0, "00000000", parameters);
    iges_check_left_out(&file, words);
}

TEST(a_line_a_curve_and_a_surface_are_read)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 2, "00000000", IGES_LINE);
    iges_add(&file, 126, 0, 0, 0, "        ", IGES_CURVE);
    iges_add(&file, 128, 0, 0, 0, "00000000", IGES_SURFACE);
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    const batten_object *line = batten_model_object(model, 0);
    const batten_surface *surface = batten_model_object(model, 2)->surface;
    CHECK_TEXT(line->name, "curve D1");
    CHECK(line->has_colour && line->colour[0] == 1 && line->colour[1] == 0);
    CHECK_BITS(batten_curve_points(line->curve)[4], 5.0);
    CHECK(!batten_curve_is_rational(batten_model_object(model, 1)->curve));
    /* u runs fastest in the file, v here. */
    CHECK_BITS(batten_surface_points(surface)[3], 0.0);
    CHECK_BITS(batten_surface_points(surface)[4], 3.0);
    CHECK_BITS(batten_surface_points(surface)[6], 2.0);
    CHECK_BITS(batten_model_unit_metres(model), 1.0);
    batten_model_unref(model);
}

TEST(Q6_counts_that_contradict_the_parameters_are_refused_with_both)
{
    check_left_out(
        126, "126,9,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,1.,0.,2.,0.,0.,0.,1.;",
        "27 parameters, need 60");
    check_left_out(126, "126,1,2,0,0,1,0,0.,0.,0.;",
                   "its degree is 2, and the upper index of its points 1");
    check_left_out(126, "126,2,26,0,0,1,0,0.;", "its degree is 26, not in 1..25");
    check_left_out(128, "128,1,0,1,0,0,0,1,0,0,0.;", "its degree is 0");
    check_left_out(128, "128,2,1,1,1,0,0,1,0,0,0.;", "11 parameters, need 43");
}

/* Reads one entity that leaves numbers out at its end. */
static batten_model *read_short(int type, const char *parameters, const char *words)
{
    char what[80];
    snprintf(what, sizeof what, "%s are left out and taken as 0", words);
    return read_noting(iges_one(type, parameters), BATTEN_FORMAT_AUTO, what);
}

TEST(numbers_left_out_at_the_end_are_0_with_a_remark)
{
    batten_model *model = read_short(110, "110,,,,3.,4.;", "6 parameters; those up to 7");
    const batten_curve *line = batten_model_object(model, 0)->curve;
    CHECK_BITS(batten_curve_points(line)[2], 0.0);
    CHECK_BITS(batten_curve_points(line)[4], 4.0);
    CHECK_BITS(batten_curve_points(line)[5], 0.0);
    batten_model_unref(model);

    /* The upper half of a circle, that ends on the x axis. */
    model = read_short(100, "100,,,,2.,0.,-2.;", "7 parameters; those up to 8");
    double length = 0;
    CHECK_OK(batten_curve_length(batten_model_object(model, 0)->curve, 1e-9, NULL, &length));
    CHECK_NEAR(length, 2 * BAT_PI, 1e-8);
    batten_model_unref(model);

    model = read_short(104, "104,1.,0.,1.,0.,0.,-1.,0.,0.,1.,-1.;",
                       "11 parameters; those up to 12");
    batten_model_unref(model);
    check_left_out(110, "110;", "1 parameter, need 7");
}

TEST(S2_a_count_that_the_file_cannot_hold_is_refused_without_memory)
{
    check_left_out(126, "126,2147483646,3,0,0,1,0,0.;",
                   "2147483646 points; the limit is 10000000");
    check_left_out(126, "126,9999998,3,0,0,1,0,0.;", "8 parameters, need 50000006");
    check_left_out(128, "128,9999998,9999998,3,3,0,0,1,0,0,0.;", "parameters, need");
    check_left_out(126, "126,4294967298,3,0,0,1,0,0.;", "too large for a count");
    check_left_out(126, "126,-1,3,0,0,1,0,0.;", "the upper index of its points -1");
}

TEST(N4_what_is_no_whole_number_is_no_count)
{
    check_left_out(126, "126,1e3,3,0,0,1,0,0.;", "parameter 1, '1e3', is not a whole number");
    check_left_out(126, "126,2.,2,0,0,1,0,0.;", "parameter 1, '2.', is not a whole number");
    check_left_out(126, "126,2,2x,0,0,1,0,0.;", "parameter 2, '2x', is not a number");
    check_left_out(126, "126,2,1Hx,0,0,1,0,0.;", "parameter 2 is not a number but a string");
    check_left_out(126, "126,99999999999999999999,2,0;", "too large for a count");
}

TEST(K3_decreasing_knots_and_K8_bad_weights_leave_the_entity_out)
{
    check_left_out(
        126, "126,2,2,0,0,1,0,0.,0.,0.,1.,0.5,1.,1.,1.,1.,0.,0.,0.,1.,1.,0.,2.,0.,0.,0.,1.;",
        "knot 5 is 0.5");
    check_left_out(
        126, "126,2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.,-1.,1.,0.,0.,0.,1.,1.,0.,2.,0.,0.,0.,1.;",
        "weight");
    check_left_out(
        126, "126,2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,1E400,1.,1.,0.,2.,0.,0.,0.,1.;",
        "parameter 18, '1E400', is too large");
}

TEST(polynomial_but_with_weights_keeps_them_with_a_note)
{
    batten_model *model = read_noting(
        iges_one(
            126,
            "126,2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,2.,1.,0.,0.,0.,1.,1.,0.,2.,0.,0.,0.,1.;"),
        BATTEN_FORMAT_AUTO, "it is declared polynomial");
    CHECK(batten_curve_is_rational(batten_model_object(model, 0)->curve));
    batten_model_unref(model);
    model = read_noting(
        iges_one(
            126,
            "126,2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,2.,2.,2.,0.,0.,0.,1.,1.,0.,2.,0.,0.,0.,1.;"),
        BATTEN_FORMAT_AUTO, "");
    CHECK(!batten_curve_is_rational(batten_model_object(model, 0)->curve));
    batten_model_unref(model);
}

#define HEAD "126,2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,1.,0.,2.,0.,0."

TEST(Q5_defaults_stand_for_what_is_missing)
{
    const struct {
        const char *text, *note;
        double a, b;
    } cases[] = {
        {HEAD ";", "", 0, 1},
        {HEAD ",,;", "its interval 0..0 is not in its domain", 0, 1},
        {HEAD ",0.,1.;", "", 0, 1},
        {HEAD ",.25D0,0.75;", "", 0.25, 0.75},
        {HEAD ",0.,1.0000000001;", "", 0, 1},
        {HEAD ",0.,2.;", "its interval 0..2 is not in its domain 0..1", 0, 1},
        {HEAD ",1.,0.;", "its interval 1..0", 0, 1},
        {"126,2,2,,,1,,,,,1.,1.,1.,1.,1.,1.,,,,1.,1.,,2.,,;", "", 0, 1},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model =
            read_noting(iges_one(126, cases[i].text), BATTEN_FORMAT_AUTO, cases[i].note);
        const batten_interval domain =
            batten_curve_domain(batten_model_object(model, 0)->curve);
        CHECK_BITS(domain.a, cases[i].a);
        CHECK_BITS(domain.b, cases[i].b);
        batten_model_unref(model);
    }
}

TEST(Q5_forms_that_are_not_known_are_left_out)
{
    const struct {
        int type, form;
    } cases[] = {{110, 1}, {110, 2}, {126, 6}, {128, 10}, {126, -1}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, cases[i].type, cases[i].form, 0, 0, "00000000",
                 cases[i].type == 110   ? IGES_LINE
                 : cases[i].type == 126 ? IGES_CURVE
                                        : IGES_SURFACE);
        iges_check_left_out(&file, "is not read; left out");
    }
}

/* ---- names ---- */

TEST(a_name_is_found_among_the_properties)
{
    const char *const tails[] = {"0.,1.,0.,0.,0.,0,1,3;", "0.,1.,0.,0.,0.,2,7,9,2,5,3;"};
    for (int i = 0; i < COUNT(tails); i++) {
        char parameters[200];
        iges_text file = iges_begin();
        snprintf(parameters, sizeof parameters, HEAD ",%s", tails[i]);
        iges_add(&file, 126, 0, 0, -7, "00000000", parameters);
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,11Hkeel, 5;6 H;");
        iges_add(&file, 406, 1, 0, 0, "00010300", "406,1,3;");
        iges_add(&file, 314, 0, 0, 0, "00000200", "314,25.,50.,100.;");
        batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
        const batten_object *object = batten_model_object(model, 0);
        CHECK_TEXT(object->name, "keel, 5;6 H");
        CHECK(object->colour[0] == 0.25 && object->colour[1] == 0.5 && object->colour[2] == 1);
        batten_model_unref(model);
    }
}

TEST(wrong_pointers_to_names_and_colours_are_ignored)
{
    static const struct {
        const char *tail, *note;
    } cases[] = {{"0,1,1;", ""},
                 {"0,1,2;", "a property of it: 2 is not the odd number of an entity"},
                 {"0,1,99;", "a property of it: it refers to entity D99, which is missing"},
                 {"0,7,1;", ""},
                 {"-5;", ""},
                 {"0,1,1Hx;", ""},
                 {"9;", ""},
                 {"0,1,3;", ""}};
    for (int i = 0; i < COUNT(cases); i++) {
        char parameters[200];
        iges_text file = iges_begin();
        snprintf(parameters, sizeof parameters, HEAD ",0.,1.,0.,0.,0.,%s", cases[i].tail);
        iges_add(&file, 126, 0, 0, 0, "00000000", parameters);
        iges_add(&file, 406, 1, 0, 0, "00010300", "406,1,5;");
        batten_model *model =
            read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, cases[i].note);
        CHECK_TEXT(batten_model_object(model, 0)->name, "curve D1");
        CHECK(!batten_model_object(model, 0)->has_colour);
        batten_model_unref(model);
    }
}

/* ---- colours and levels ---- */

static void check_wrong(iges_text *file, const char *line, int where, const char *words)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(read_text(iges_end(file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model));
    CHECK(!batten_model_object(model, 0)->has_colour);
    CHECK_TEXT(batten_model_object(model, 0)->layer, "");
    if (!batten_notes_dropped(notes)) {
        int first = 0;
        while (batten_notes_at(notes, first)->is_remark)
            first++;
        const batten_note *note = batten_notes_at(notes, first);
        CHECK_INT(count_warnings(notes), 1);
        CHECK_TEXT(note->text, words);
        CHECK_CONTAINS(note->entity, line);
        CHECK_INT(note->line, where);
    }
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* One note says which entity is the first, where it stands and what is wrong, and of how many.
 */
TEST(Q4_wrong_colours_are_none_and_said_once)
{
    static const struct {
        int colour;
        const char *why;
    } cases[] = {{9, "colours have the numbers 0 to 8"},
                 {-99, "it refers to entity D99, which is missing"},
                 {-4, "4 is not the odd number of an entity"},
                 {-3, "it refers to entity D3 as type 314, which is of type 124"},
                 {-5, "D5: part 2 is 120 percent"},
                 {-7, "D7: parameter 2 is not a number but a string"}};
    for (int i = 0; i < COUNT(cases); i++)
        for (int count = 1; count < 4; count += 2) {
            char words[200];
            iges_text file = iges_begin();
            iges_add(&file, 110, 0, 0, cases[i].colour, "00000000", IGES_LINE);
            iges_add(&file, 124, 0, 0, 0, "00000000",
                     "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.;");
            iges_add(&file, 314, 0, 0, 0, "00000200", "314,0.,120.,0.;");
            iges_add(&file, 314, 0, 0, 0, "00000200", "314,0.,1Hx,0.;");
            for (int k = 1; k < count; k++)
                iges_add(&file, 110, 0, 0, cases[i].colour, "00000000", IGES_LINE);
            snprintf(words, sizeof words, "its colour is %d: %s; taken as none%s",
                     cases[i].colour, cases[i].why,
                     count > 1 ? "; so of 3 entities in all" : "");
            check_wrong(&file, "#1 ", 4, words);
        }
}

TEST(Q4_wrong_levels_are_none_and_said_once)
{
    static const struct {
        int level;
        const char *why;
    } cases[] = {
        {-99, "it refers to entity D99, which is missing"},
        {-1, "it refers to entity D1 as type 406, which is of type 110"},
        {-3, "it refers to entity D3 as a list of levels, form 1, which is of form 15"},
        {-5, "D5: parameter 2 is not a number but a string"}};
    for (int i = 0; i < COUNT(cases); i++) {
        char words[200], level[9];
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,1Hx;");
        iges_add(&file, 406, 1, 0, 0, "00010300", "406,1,1Hx;");
        snprintf(level, sizeof level, "%8d", cases[i].level);
        memcpy(file.directory + 32, level, 8);
        snprintf(words, sizeof words, "its level is %d: %s; taken as none", cases[i].level,
                 cases[i].why);
        check_wrong(&file, "#1 ", 4, words);
    }
}

/* ---- matrices ---- */

TEST(a_chain_of_matrices_applies_the_inner_one_first)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 3, 0, "00000000", "110,1.,0.,0.,0.,0.,0.;");
    /* A quarter turn about z, then, by its own matrix, a move along x. */
    iges_add(&file, 124, 0, 5, 0, "00000000", "124,0.,-1.,0.,0.,1.,0.,0.,0.,0.,0.,1.,0.;");
    iges_add(&file, 124, 0, 0, 0, "00000000", "124,1.,0.,0.,10.,0.,1.,0.,0.,0.,0.,1.,0.;");
    iges_add(&file, 128, 0, 5, 0, "00000000", IGES_SURFACE);
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    const double *points = batten_curve_points(batten_model_object(model, 0)->curve);
    CHECK_BITS(points[0], 10.0);
    CHECK_BITS(points[1], 1.0);
    CHECK_BITS(points[3], 10.0);
    CHECK_BITS(batten_surface_points(batten_model_object(model, 1)->surface)[0], 10.0);
    batten_model_unref(model);
}

static void check_bad_matrix(int transform, int inner, const char *matrix, const char *words)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, transform, 0, "00000000", IGES_LINE);
    iges_add(&file, 124, 0, inner, 0, "00000000", matrix);
    iges_check_left_out(&file, words);
}

TEST(Q4_references_to_nothing_to_another_type_or_in_a_ring_leave_the_entity_out)
{
    static const char unit[] = "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.;";
    check_bad_matrix(99, 0, unit, "it refers to entity D99, which is missing");
    check_bad_matrix(1, 0, unit, "it refers to entity D1 as type 124, which is of type 110");
    check_bad_matrix(2, 0, unit, "2 is not the odd number of an entity");
    check_bad_matrix(-3, 0, unit, "-3 is not the odd number");
    check_bad_matrix(3, 3, unit, "its matrices refer to one another in a ring");
    check_bad_matrix(3, 0, "124,1.,0.,0.;", "the matrix D3 differs from a rotation by 1");
    check_bad_matrix(3, 0, "124,2.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.;",
                     "differs from a rotation by 3");
    check_bad_matrix(3, 0, "124,a;", "parameter 1, 'a', is not a number");
    check_bad_matrix(3, 0, "124,1.", "is not a number");
}

TEST(a_matrix_that_is_nearly_a_rotation_is_made_one_with_a_note)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 3, 0, "00000000", "110,1.,0.,0.,0.,0.,0.;");
    iges_add(&file, 124, 0, 0, 0, "00000000",
             "124,1.0000001,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO,
                                      "the matrix differs from a rotation by 2e-07; made a "
                                      "rotation");
    CHECK_BITS(batten_curve_points(batten_model_object(model, 0)->curve)[0], 1.0);
    batten_model_unref(model);
}

TEST(what_is_hidden_says_so_and_definitions_are_not_read)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "01000000", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 2);
    CHECK(batten_model_object(model, 0)->is_hidden);
    CHECK(!batten_model_object(model, 1)->is_hidden);
    batten_model_unref(model);
    iges_text other = iges_begin();
    iges_add(&other, 110, 0, 0, 0, "00000200", IGES_LINE);
    iges_check_left_out(&other, "its use is 2, a definition, and not geometry; left out");
}

TEST(points_that_are_called_positional_are_read)
{
    iges_text file = iges_begin();
    iges_add(&file, 116, 0, 0, 0, "00020400", "116,1.,2.,3.,0;");
    iges_add(&file, 402, 1, 0, 0, "00000000", "402,1,1;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_POINTS);
    CHECK_TEXT(batten_model_object(model, 0)->group, "group D3");
    batten_model_unref(model);
}

TEST(references_say_what_is_a_part_and_flags_that_disagree_are_noted)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00010000", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000500", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000000", "110,0.,0.,0.,1.,0.,0.;");
    iges_add(&file, 102, 0, 0, 0, "00000000", "102,1,5;");
    batten_model *model =
        read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO,
                    "entities declared as parts of others to which nothing refers: 1");
    CHECK_INT(batten_model_count(model), 2);
    CHECK_BITS(batten_curve_points(batten_model_object(model, 0)->curve)[0], 1.0);
    CHECK_BITS(batten_curve_points(batten_model_object(model, 1)->curve)[0], 0.0);
    batten_model_unref(model);
}

TEST(P4_entities_of_other_types_are_counted_by_name)
{
    iges_text file = iges_begin();
    iges_add(&file, 150, 0, 0, 0, "00000000", "150,1.,2.,3.;");
    iges_check_left_out(&file, "0 read, 1 left out");
    char name[BAT_IGES_TYPE_NAME];
    const bat_iges_reading reading = {.types = bat_iges_all_types()};
    bat_iges_name_of_type(&reading, 150, name);
    CHECK_TEXT(name, "150 block");
    bat_iges_name_of_type(&reading, 5001, name);
    CHECK_TEXT(name, "5001, an unknown type");
    iges_text named = iges_begin();
    iges_add(&named, 158, 0, 0, 0, "00000000", "158,1.;");
    iges_check_left_out(&named, "entities of this type are not read; this is the first");
    check_refused(iges_one(777, "777,1;"), BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED,
                  "its 1 entity could not be read");
    iges_text empty = iges_begin();
    batten_model *model = read_noting(iges_end(&empty, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 0);
    batten_model_unref(model);
}
