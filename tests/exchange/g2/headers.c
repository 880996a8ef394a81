/* Which lines begin an object, and the names of the classes. */
#include "exchange/g2/g2.h"
#include "exchange/reading.h"

/* Is the first word of the text the start of a header? */
static bool is_header(const char *text)
{
    bat_input input = {.data = text, .size = strlen(text)};
    bat_words words;
    bat_words_begin(&words, &input);
    return bat_words_next(&words) && bat_g2_is_header(words);
}

TEST(a_header_is_a_class_a_version_and_none_or_four_numbers_to_follow)
{
    static const char *const headers[] = {"100 1 0 0\n", "100 1 0 4 255 0 0 255\n",
                                          "999 1 0 0"};
    CHECK(is_header(headers[0]) && is_header(headers[1]) && !is_header(headers[2]));
    CHECK(is_header("100 0 0 0\n") && is_header("700 1 3 0\n"));
    static const char *const others[] = {"100 1 0\n",   "100 1\n0 0\n",  "100 2 0 0\n",
                                         "100 1 0 3\n", "100.5 1 0 0\n", "101 1 0 0\n",
                                         "99 1 0 0\n",  "1000 1 0 0\n",  "100 1 0 x\n",
                                         "1 0 0 0\n",   "100 1 0 5\n",   "100 -1 0 0\n"};
    for (int i = 0; i < COUNT(others); i++)
        CHECK(!is_header(others[i]));
}

/* The second and the third word of a line begin nothing. */
TEST(a_header_begins_its_line)
{
    static const char text[] = "7 100 1 0 0\n";
    bat_input input = {.data = text, .size = strlen(text)};
    bat_words words;
    bat_words_begin(&words, &input);
    CHECK(bat_words_next(&words) && bat_words_next(&words) && !bat_g2_is_header(words));
}

TEST(classes_have_the_names_that_the_format_gives_them)
{
    static const struct {
        int class;
        const char *name;
    } classes[] = {{100, "spline curve"},
                   {110, "curve on a surface"},
                   {120, "line"},
                   {130, "circle"},
                   {140, "ellipse"},
                   {150, "bounded curve"},
                   {160, "hyperbola"},
                   {170, "parabola"},
                   {200, "spline surface"},
                   {210, "bounded surface"},
                   {240, "composite surface"},
                   {250, "plane"},
                   {260, "cylinder"},
                   {270, "sphere"},
                   {280, "cone"},
                   {290, "torus"},
                   {291, "surface of revolution"},
                   {292, "disc"},
                   {293, "locally refined surface"},
                   {310, "triangles"},
                   {400, "points"},
                   {410, "line segments"},
                   {700, "spline volume"}};
    for (int i = 0; i < COUNT(classes); i++)
        CHECK_TEXT(bat_g2_class_name(classes[i].class), classes[i].name);
    CHECK(bat_g2_class_name(0) == NULL && bat_g2_class_name(300) == NULL);
}

TEST(an_object_ends_where_the_file_does_or_where_a_header_begins)
{
    static const char text[] = "1 2\n3 4\n100 1 0 0\n5";
    bat_input input = {.data = text, .size = strlen(text)};
    bat_words words;
    static const bool ends[] = {false, false, false, true};
    bat_words_begin(&words, &input);
    for (int i = 0; i < COUNT(ends); i++) {
        CHECK(bat_words_next(&words));
        CHECK(bat_g2_is_at_end(&words) == ends[i]);
    }
    while (bat_words_next(&words))
        ;
    CHECK(bat_g2_is_at_end(&words));
}
