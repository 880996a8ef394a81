/* Numbers of every format: each one of a small file is replaced by those that are none, too
 * large, or not whole. */
#include <ctype.h>
#include <stdlib.h>

#include "exchange/every_format.h"
#include "exchange/reading.h"

/* Where the next number of a text begins, and how long it is; false for none. */
static bool next_number(const char *text, size_t *at, size_t *length)
{
    for (size_t i = *at; text[i]; i++) {
        const bool is_new =
            i == 0 || (!isalnum((unsigned char)text[i - 1]) && text[i - 1] != '.');
        if (!is_new ||
            !(isdigit((unsigned char)text[i]) ||
              ((text[i] == '-' || text[i] == '.') && isdigit((unsigned char)text[i + 1]))))
            continue;
        *at = i;
        *length = 1 + strspn(text + i + 1, "0123456789.eE");
        return true;
    }
    return false;
}

/* The text with another number there. In records of 80 columns the blanks that follow give way,
 * or what is beyond column 72 moves: that harms no more than it should. */
static char *with_number(char *room, const char *text, size_t at, size_t length,
                         const char *number)
{
    const size_t more = strlen(number) > length ? strlen(number) - length : 0;
    const char *rest = text + at + length, *line = strchr(rest, '\n');
    char *to = room + sprintf(room, "%.*s%s", (int)at, text, number);
    const char *blank = strstr(rest, "  ");
    if (more > 0 && blank && line && blank < line && strspn(blank, " ") > more) {
        to += sprintf(to, "%.*s", (int)(blank - rest), rest);
        rest = blank + more;
    }
    strcpy(to, rest);
    return room;
}

static bool are_finite(const double *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(numbers[i]))
            return false;
    return true;
}

static void check_finite(const batten_model *model)
{
    for (int i = 0; model && i < batten_model_count(model); i++) {
        const batten_object *o = batten_model_object(model, i);
        if (o->points)
            CHECK(are_finite(o->points, 3 * (size_t)o->point_count));
        if (o->curve)
            CHECK(are_finite(batten_curve_points(o->curve),
                             (size_t)batten_curve_dimension(o->curve) *
                                 (size_t)batten_curve_point_count(o->curve)));
        if (o->mesh)
            CHECK(are_finite(batten_mesh_view(o->mesh)->points,
                             3 * (size_t)batten_mesh_view(o->mesh)->vertex_count));
    }
}

/* Every number of every format once as each of these, in 2 MiB. */
static void replace_all(const char *const *numbers, int count)
{
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    for (int f = 0; f < COUNT(every_format); f++) {
        const char *text = every_format[f].text;
        char *room = test_array(strlen(text) + 500, 1);
        for (size_t at = 0, length = 0; next_number(text, &at, &length); at += length)
            for (int i = 0; i < count; i++) {
                batten_read_options options = batten_read_defaults();
                batten_limits limits = batten_limits_defaults();
                batten_model *model = NULL;
                limits.memory_bytes = (size_t)2 << 20;
                options.limits = &limits;
                options.format = every_format[f].format;
                with_number(room, text, at, length, numbers[i]);
                const batten_status status =
                    batten_read_memory(room, strlen(room), &options, NULL, NULL, &model);
                CHECK((status == BATTEN_OK || status == BATTEN_PARTLY_READ) == (model != NULL));
                /* Counts are held against the file before memory is asked for. */
                CHECK(status != BATTEN_OUT_OF_MEMORY);
                CHECK(status != BATTEN_TOO_LARGE || !strstr(batten_message(), "memory"));
                check_finite(model);
                batten_model_unref(model);
            }
    }
}

TEST(N1_no_reader_hands_on_what_is_no_number)
{
    static const char *const numbers[] = {"nan", "inf",   "-inf",  "-nan",
                                          "NaN", "1e400", "-1e400"};
    replace_all(numbers, COUNT(numbers));
}

TEST(N2_no_reader_makes_infinity_of_large_numbers)
{
    static const char *const numbers[] = {"1e300", "-1e300", "1e-300", "1e155", "1e9", "1e-9"};
    replace_all(numbers, COUNT(numbers));
}

TEST(N4_counts_that_are_none_harm_no_reader)
{
    static const char *const numbers[] = {"-1", "1e3", "1.5", "99999999999999999999",
                                          "",   "--1", "x"};
    replace_all(numbers, COUNT(numbers));
}

TEST(N5_minus_0_and_denormal_numbers_are_read_by_each_reader)
{
    static const char *const numbers[] = {"-0", "-0.0", "5e-324", "1e-310", "1e-400"};
    replace_all(numbers, COUNT(numbers));
}

TEST(S1_counts_at_the_bounds_of_integers_harm_no_reader)
{
    static const char *const numbers[] = {
        "0",           "2147483647",          "2147483648",           "4294967296",
        "-2147483648", "9223372036854775807", "18446744073709551616", "65536"};
    replace_all(numbers, COUNT(numbers));
}

TEST(S2_a_promise_of_a_thousand_million_takes_no_memory_in_any_reader)
{
    static const char *const numbers[] = {"1000000000", "100000000"};
    replace_all(numbers, COUNT(numbers));
}

/* ---- how numbers may be written ---- */

/* y: read as the number; n: refused, or left out; -: what comes of it is the affair of others.
 */
typedef struct {
    batten_format format;
    const char *before, *after; /* of the x of the first point */
    const char *read;           /* for each of the texts */
} notation;

static const struct {
    const char *text;
    double value;
} texts[] = {{"nan", 0},    {"inf", 0},    {"0x1p3", 8},    {"1e400", 0},
             {"1e-400", 0}, {"1.5e1", 15}, {".5", 0.5},     {"5.", 5},
             {"+1", 1},     {"--1", 1},    {"1.D+3", 1000}, {"-2.5E-1", -0.25}};

static const notation notations[] = {
    {BATTEN_FORMAT_POINTS, "", " 2 3\n4 5 6\n", "nnnnyyyyynny"},
    {BATTEN_FORMAT_STEP, STEP_BEGIN "#1=CARTESIAN_POINT('',(",
     ",2.,3.));\n#2=CARTESIAN_POINT('',(1.5,2.,4.));\n"
     "#4=POLYLINE('name',(#1,#2));\n" STEP_CONTEXT STEP_END,
     "nnnny--y-n-y"},
    {BATTEN_FORMAT_DXF, "0\nSECTION\n2\nENTITIES\n0\nPOINT\n10\n",
     "\n20\n2\n30\n3\n0\nENDSEC\n0\nEOF\n", "nnnnyyyyynny"},
    {BATTEN_FORMAT_G2, "400 1 0 0\n2\n", " 2 3\n4 5 6\n", "nnnnyyyyynny"},
    {BATTEN_FORMAT_OBJ, "v ", " 2 3\nv 4 5 6\np 1 2\n", "nnnnyyyyynny"},
    {BATTEN_FORMAT_PLY,
     "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
     "property double z\nend_header\n",
     " 2 3\n4 5 6\n", "nnnnyyyyynny"},
    {BATTEN_FORMAT_PCD,
     "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
     "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n",
     " 2 3\n4 5 6\n", "-nnnyyyyynny"},
};

static double first_x(const batten_model *model)
{
    const batten_object *o = batten_model_object(model, 0);
    return o->curve ? batten_curve_points(o->curve)[0] : o->points[0];
}

TEST(N3_each_reader_takes_the_notations_of_its_format)
{
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    for (int f = 0; f < COUNT(notations); f++)
        for (int i = 0; i < COUNT(texts); i++) {
            char text[2000];
            batten_model *model = NULL;
            snprintf(text, sizeof text, "%s%s%s", notations[f].before, texts[i].text,
                     notations[f].after);
            const batten_status status = read_text(text, notations[f].format, NULL, &model);
            const bool same = status == BATTEN_OK && first_x(model) == texts[i].value;
            if (notations[f].read[i] != '-' && (notations[f].read[i] == 'y') != same)
                printf("%s as %s: status %d\n", texts[i].text,
                       batten_format_name(notations[f].format), status);
            CHECK(notations[f].read[i] == '-' || (notations[f].read[i] == 'y') == same);
            if (notations[f].read[i] == 'n')
                CHECK(status != BATTEN_OK);
            batten_model_unref(model);
        }
}
