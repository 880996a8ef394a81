/* Entities opened: counts, numbers left out, defaults, forms. */
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
