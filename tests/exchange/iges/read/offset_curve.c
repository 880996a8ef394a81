/* 130: offset curves of constant distance, whole or in part, to either side. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", root[] = "00000000";

/* A line from (0, 0) to (4, 0): to its left, seen against the normal, by the distance. */
static const struct {
    const char *parameters, *note;
    double from[2], to[2];
} cases[] = {
    {"130,1,1,,,,.5,,,,0.,0.,1.,0.,1.;", "", {0, 0.5}, {4, 0.5}},
    {"130,1,1,,,,-.5,,,,0.,0.,1.,0.,1.;", "", {0, -0.5}, {4, -0.5}},
    {"130,1,1,,,,.5,,,,0.,0.,-2.,0.,1.;", "", {0, -0.5}, {4, -0.5}},
    {"130,1,1,,,,.5,,,,0.,0.,1.,.25,.75;", "", {1, 0.5}, {3, 0.5}},
    {"130,1,1,,,,.5,,,,0.,0.,1.,.25,1.;", "", {1, 0.5}, {4, 0.5}},
    {"130,1,1,,,,.5,,,,0.,0.,1.,0.,2.;",
     "its interval 0..2 is not in its domain 0..1",
     {0, 0.5},
     {4, 0.5}},
    {"130,1,2,,,1,.5,0.,.5,1.,0.,0.,1.,0.,1.;", "", {0, 0.5}, {4, 0.5}},
    {"130,1,2,,,1,.5,0.,.75,1.,0.,0.,1.,0.,1.;",
     "its distance varies (flag 2), which is not read",
     {0},
     {0}},
    {"130,1,3,1,1,2,.5,,.5,,0.,0.,1.,0.,1.;",
     "its distance varies (flag 3), which is not read",
     {0},
     {0}},
    {"130,1,0,,,,.5,,,,0.,0.,1.,0.,1.;",
     "its distance varies (flag 0), which is not read",
     {0},
     {0}},
};

TEST(an_offset_is_to_the_left_of_the_part_that_is_asked_for)
{
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, part, "110,0.,0.,0.,4.,0.,0.;");
        iges_add(&file, 130, 0, 0, 0, root, cases[i].parameters);
        if (strstr(cases[i].note, "varies")) {
            iges_check_left_out(&file, cases[i].note);
            continue;
        }
        batten_model *model =
            read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, cases[i].note);
        CHECK_INT(batten_model_count(model), 1);
        const batten_curve *curve = batten_model_object(model, 0)->curve;
        const batten_interval domain = batten_curve_domain(curve);
        double p[3], q[3];
        CHECK_OK(batten_curve_evaluate(curve, domain.a, 0, p));
        CHECK_OK(batten_curve_evaluate(curve, domain.b, 0, q));
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(p[k], cases[i].from[k], 1e-12);
            CHECK_NEAR(q[k], cases[i].to[k], 1e-12);
        }
        batten_model_unref(model);
    }
}
