/* Lines and conics: their measures, and their parts by parameters in either direction. */
#include "exchange/step/parsing.h"
#include "exchange/step/read/shapes.h"

static const bat_step_scale millimetres = {1, 1, 1e-6};

/* In the plane of x and y at the origin. */
#define COMMON                                                                                   \
    "#1=CARTESIAN_POINT('',(0.,0.,0.));#2=DIRECTION('',(0.,0.,1.));#3=DIRECTION('',(1.,0.,0.));" \
    "#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);#5=VECTOR('',#3,2.);#6=LINE('',#1,#5);"                  \
    "#7=CIRCLE('',#4,5.);#8=ELLIPSE('',#4,4.,2.);#9=PARABOLA('',#4,0.5);"                        \
    "#10=HYPERBOLA('',#4,3.,4.);"

/* The formulas of ISO 10303-42: of a line 2 t, of a parabola (a t^2, 2 a t), of a hyperbola (a cosh t,
 * b sinh t). */
static void point_of(int curve, double t, double p[2])
{
    p[0] = curve == 6   ? 2 * t
           : curve == 7 ? 5 * cos(t)
           : curve == 8 ? 4 * cos(t)
           : curve == 9 ? 0.5 * t * t
                        : 3 * cosh(t);
    p[1] = curve == 6   ? 0
           : curve == 7 ? 5 * sin(t)
           : curve == 8 ? 2 * sin(t)
           : curve == 9 ? t
                        : 4 * sinh(t);
}

static const struct {
    double from, to;
    bool forward;
} parts[] = {{0.25, 1.5, true},
             {1.5, 0.25, false},
             {-1, 0.5, true},
             {-1.25, -0.5, true},
             {0.5, -1, false}};

TEST(a_part_runs_from_one_parameter_to_the_other)
{
    for (int curve = 6; curve <= 10; curve++)
        for (int i = 0; i < COUNT(parts); i++) {
            char data[900];
            step_text_file t = {.notes = NULL};
            batten_curve *made = NULL;
            snprintf(data, sizeof data,
                     COMMON
                     "#100=TRIMMED_CURVE('',#%d,(PARAMETER_VALUE(%g)),(PARAMETER_VALUE(%g)),"
                     "%s,.PARAMETER.);",
                     curve, parts[i].from, parts[i].to, parts[i].forward ? ".T." : ".F.");
            CHECK_OK(step_begin(&t, step_whole(data)));
            CHECK_OK(bat_step_read_curve(&t.file, step_find(&t, 100), &millimetres, &made));
            const batten_interval domain = batten_curve_domain(made);
            for (int last = 0; last < 2; last++) {
                double p[3], due[2];
                point_of(curve, last ? parts[i].to : parts[i].from, due);
                CHECK_OK(batten_curve_evaluate(made, last ? domain.b : domain.a, 0, p));
                CHECK_NEAR(p[0], due[0], 1e-13);
                CHECK_NEAR(p[1], due[1], 1e-13);
            }
            /* Of the ends the curve is the shorter way: its points stay beside its chord. */
            double middle[3], half[2];
            CHECK_OK(batten_curve_evaluate(made, (domain.a + domain.b) / 2, 0, middle));
            point_of(curve, (parts[i].from + parts[i].to) / 2, half);
            CHECK(hypot(middle[0] - half[0], middle[1] - half[1]) < 1);
            batten_curve_unref(made);
            step_end(&t);
        }
}

TEST(measures_of_conics_must_be_positive)
{
    static const struct {
        const char *curve, *words;
    } cases[] = {
        {"#100=CIRCLE('',#4,0.);", "#100 CIRCLE: its radius is 0; it must be positive"},
        {"#100=CIRCLE('',#4,-5.);", "#100 CIRCLE: its radius is -5; it must be positive"},
        {"#100=ELLIPSE('',#4,0.,1.);", "#100 ELLIPSE: its first half axis is 0; it must be"},
        {"#100=ELLIPSE('',#4,1.,-2.);", "#100 ELLIPSE: its second half axis is -2; it must be"},
        {"#100=PARABOLA('',#4,-1.);", "#100 PARABOLA: its focal distance is -1; it must be"},
        {"#100=HYPERBOLA('',#4,-1.,1.);", "#100 HYPERBOLA: its half axis is -1; it must be"},
        {"#100=HYPERBOLA('',#4,1.,0.);", "#100 HYPERBOLA: its imaginary half axis is 0; it"},
        {"#100=LINE('',#1,#5);", "#100 LINE: it has no ends"},
        {"#100=PARABOLA('',#4,1.);", "#100 PARABOLA: it has no ends"},
        {"#100=HYPERBOLA('',#4,1.,1.);", "#100 HYPERBOLA: it has no ends"},
        {"#100=TRIMMED_CURVE('',#7,(PARAMETER_VALUE(1E6)),(PARAMETER_VALUE(0.)),.T.,.PARAMETER.);",
         "the angles 1e+06 and 0 do not bound a part"},
        {"#100=TRIMMED_CURVE('',#7,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(-1E6)),.T.,.PARAMETER.);",
         "the angles 0 and -1e+06 do not bound a part"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char data[900];
        step_text_file t = {.notes = NULL};
        batten_curve *made = NULL;
        snprintf(data, sizeof data, COMMON "%s", cases[i].curve);
        CHECK_OK(step_begin(&t, step_whole(data)));
        CHECK(bat_step_read_curve(&t.file, step_find(&t, 100), &millimetres, &made) !=
              BATTEN_OK);
        CHECK(made == NULL);
        if (test_cases(10) >= 10)
            CHECK_MESSAGE(cases[i].words);
        step_end(&t);
    }
}
