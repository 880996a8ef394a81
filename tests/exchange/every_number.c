/* Numbers of every format: each one of a small file is replaced by those that are none, too
 * large, or not whole. */
#include <stdlib.h>

#include "exchange/every_format.h"
#include "exchange/replace.h"

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

/* ---- counts ---- */

static const struct {
    batten_format format;
    const char *before, *good, *after; /* of a count */
} counts[] = {
    {BATTEN_FORMAT_DXF, "0\nSECTION\n2\nENTITIES\n0\nSPLINE\n71\n", "1",
     "\n73\n2\n40\n0\n40\n0\n40\n1\n40\n1\n10\n0\n20\n0\n10\n1\n20\n0\n0\nENDSEC\n0\nEOF\n"},
    {BATTEN_FORMAT_G2, "100 1 0 0\n3 0\n", "3", " 3\n0 0 0 1 1 1\n0 0 0\n1 2.5 0\n2 0 0\n"},
    {BATTEN_FORMAT_G2, "400 1 0 0\n", "2", "\n1 2 3\n4 5 6\n"},
    {BATTEN_FORMAT_OBJ, "v 0 0 0\nv 1 0 0\ncstype bspline\ndeg ", "1",
     "\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n"},
    {BATTEN_FORMAT_PLY, "ply\nformat ascii 1.0\nelement vertex ", "2",
     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n1 0 0\n"},
    {BATTEN_FORMAT_PCD,
     "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
     "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS ",
     "2", "\nDATA ascii\n1 2 3\n1.5 2 3\n"},
    {BATTEN_FORMAT_OFF, "OFF\n", "3", " 1 0\n0 0 0\n1 0 0\n1 1.5 0\n3 0 1 2\n"},
    {BATTEN_FORMAT_OFF, "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1.5 0\n", "3", " 0 1 2\n"},
    {BATTEN_FORMAT_FTM,
     "FREE!ship\n2.6\n1\n1\nSide\n3\n255\n1\n1\n1\n1\n1\n0\n0\n1\n171\n0\n"
     "4\n0 0 0\n1\n0\n0\n1 0 0\n1\n0\n0\n1 1 0\n1\n0\n0\n0 1 0.5\n1\n0\n0\n0\n0\n1\n",
     "4", "\n0\n1\n2\n3\n0\n0\n0\n"},
    {BATTEN_FORMAT_STEP,
     STEP_BEGIN "#1=CARTESIAN_POINT('',(1.,2.,3.));\n#2=CARTESIAN_POINT('',(1.5,2.,4.));\n"
                "#4=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#2),.UNSPECIFIED.,.F.,.F.,(2,",
     "2", "),(0.,1.),.UNSPECIFIED.);\n" STEP_CONTEXT STEP_END},
};

TEST(N4_a_count_is_digits_and_its_place_is_told)
{
    static const char *const bad[] = {
        "-1", "1e3", "2e0", "2.0", "2x", "+", "99999999999999999999"};
    int wrong = 0;
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    for (int f = 0; f < COUNT(counts); f++)
        for (int i = -1; i < COUNT(bad); i++) {
            char text[2000];
            batten_model *model = NULL;
            batten_notes *notes = NULL;
            CHECK_OK(batten_notes_create(10, &notes));
            snprintf(text, sizeof text, "%s%s%s", counts[f].before,
                     i < 0 ? counts[f].good : bad[i], counts[f].after);
            const batten_status status = read_text(text, counts[f].format, notes, &model);
            const bool is_told = status == BATTEN_PARTLY_READ
                                     ? count_warnings(notes) > 0
                                     : status != BATTEN_OK && strlen(batten_message()) > 3;
            const bool is_right = i < 0 ? status == BATTEN_OK : is_told;
            if (!is_right)
                printf("%s as count %d: status %d\n", i < 0 ? counts[f].good : bad[i], f,
                       status);
            wrong += !is_right;
            batten_notes_free(notes);
            batten_model_unref(model);
        }
    CHECK_INT(wrong, 0);
}
