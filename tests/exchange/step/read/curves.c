#include "exchange/step/parsing.h"
#include "exchange/step/read/shapes.h"

#include <batten/measure.h>

static const bat_step_scale millimetres = {1, 1, 1e-6};

/* A frame at (1, 2, 3) with z = (0, 0, 1), x = (0, 1, 0), and what is common. */
#define COMMON                                                                            \
    "#1=CARTESIAN_POINT('',(1.,2.,3.));#2=DIRECTION('',(0.,0.,1.));"                      \
    "#3=DIRECTION('',(0.,2.,5.));#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);"                     \
    "#5=CARTESIAN_POINT('',(1.,7.,3.));#6=CARTESIAN_POINT('',(-4.,2.,3.));"               \
    "#7=VECTOR('',#3,2.);#8=LINE('',#1,#7);#9=CIRCLE('',#4,5.);#10=ELLIPSE('',#4,4.,2.);" \
    "#11=PARABOLA('',#4,0.5);#12=HYPERBOLA('',#4,3.,4.);"                                 \
    "#13=DIRECTION('',(1.,0.,0.));#14=VECTOR('',#13,2.);#15=LINE('',#1,#14);"             \
    "#16=CARTESIAN_POINT('',(4.,2.,3.));"

/* Curve #100 of the text. */
static batten_curve *curve_of(const char *data, const bat_step_scale *scale, int left_out)
{
    char *text = test_array(strlen(data) + strlen(COMMON) + 1, 1);
    batten_curve *curve = NULL;
    step_text_file t = {.notes = NULL};
    strcat(strcpy(text, COMMON), data);
    CHECK_OK(step_begin(&t, step_whole(text)));
    CHECK_OK(bat_step_read_curve(&t.file, step_find(&t, 100), scale, &curve));
    CHECK_INT(t.input.left_out, left_out);
    step_end(&t);
    return curve;
}

static void check_at(const batten_curve *curve, double share, double x, double y, double z)
{
    const batten_interval domain = batten_curve_domain(curve);
    double point[3];
    CHECK_OK(batten_curve_evaluate(curve, domain.a + share * (domain.b - domain.a), 0, point));
    CHECK_NEAR(point[0], x, 1e-13 * (1 + fabs(x)));
    CHECK_NEAR(point[1], y, 1e-13 * (1 + fabs(y)));
    CHECK_NEAR(point[2], z, 1e-13 * (1 + fabs(z)));
}

static void check_refusal(const char *data, batten_status status, const char *words)
{
    char *text = test_array(strlen(data) + strlen(COMMON) + 1, 1);
    batten_curve *curve = NULL;
    step_text_file t = {.notes = NULL};
    strcat(strcpy(text, COMMON), data);
    CHECK_OK(step_begin(&t, step_whole(text)));
    CHECK_STATUS(bat_step_read_curve(&t.file, step_find(&t, 100), &millimetres, &curve),
                 status);
    CHECK_MESSAGE(words);
    CHECK(curve == NULL);
    step_end(&t);
}

TEST(step_directions_of_length_one_keep_their_bits)
{
    static const struct {
        const char *text;
        double read[3];
    } cases[] = {{"#100=DIRECTION('',(0.9683640522700838,0.24209101306752095,"
                  "0.06052275326688024));",
                  {0.9683640522700838, 0.24209101306752095, 0.06052275326688024}},
                 {"#100=DIRECTION('',(0.968364052270084,0.242091013067521,"
                  "0.06052275326688025));",
                  {0.968364052270084, 0.242091013067521, 0.06052275326688025}},
                 {"#100=DIRECTION('',(0.,3.,4.));", {0, 3 * (1 / 5.0), 4 * (1 / 5.0)}}};
    for (int k = 0; k < COUNT(cases); k++) {
        step_text_file t = {.notes = NULL};
        double direction[3];
        CHECK_OK(step_begin(&t, step_whole(cases[k].text)));
        CHECK_OK(bat_step_read_direction(&t.file, step_find(&t, 100), direction));
        for (int i = 0; i < 3; i++)
            CHECK_BITS(direction[i], cases[k].read[i]);
        step_end(&t);
    }
}

TEST(step_placements_project_x_and_have_defaults)
{
    const struct {
        const char *data;
        double x[3], z[3];
    } cases[] = {{"#100=AXIS2_PLACEMENT_3D('',#1,#2,#3);", {0, 1, 0}, {0, 0, 1}},
                 {"#100=AXIS2_PLACEMENT_3D('',#1,$,$);", {1, 0, 0}, {0, 0, 1}},
                 {"#100=AXIS2_PLACEMENT_3D('',#1,#13,$);", {0, 1, 0}, {1, 0, 0}},
                 {"#100=AXIS1_PLACEMENT('',#1,$);", {1, 0, 0}, {0, 0, 1}},
                 {"#50=DIRECTION('',(0.,1E200,0.));#100=AXIS2_PLACEMENT_3D('',#1,#50,#13);",
                  {1, 0, 0},
                  {0, 1, 0}}};
    for (int k = 0; k < COUNT(cases); k++) {
        char text[1000];
        batten_frame frame;
        step_text_file t = {.notes = NULL};
        const bat_step_scale inches = {25.4, 1, 1e-6};
        snprintf(text, sizeof text, "%s%s", COMMON, cases[k].data);
        CHECK_OK(step_begin(&t, step_whole(text)));
        CHECK_OK(bat_step_read_placement(&t.file, step_find(&t, 100), &inches, &frame));
        CHECK_BITS(frame.origin.x, 25.4);
        CHECK_BITS(frame.origin.z, 3 * 25.4);
        CHECK_NEAR(frame.x.x, cases[k].x[0], 1e-15);
        CHECK_NEAR(frame.x.y, cases[k].x[1], 1e-15);
        CHECK_NEAR(frame.z.x, cases[k].z[0], 1e-15);
        CHECK_NEAR(frame.z.z, cases[k].z[2], 1e-15);
        step_end(&t);
    }
}

TEST(P2_bad_placements_and_points_are_named)
{
    const struct {
        const char *data, *words;
    } cases[] = {
        {"#100=CIRCLE('',#50,1.);#50=AXIS2_PLACEMENT_3D('',#1,#2,#2);",
         "#50 AXIS2_PLACEMENT_3D: the axes of the frame are parallel"},
        {"#100=CIRCLE('',#50,1.);#50=AXIS2_PLACEMENT_3D('',#51,$,$);"
         "#51=CARTESIAN_POINT('',(1.,2.));",
         "#51 CARTESIAN_POINT: an item of argument 2 is missing, not a number"},
        {"#100=CIRCLE('',#50,1.);#50=AXIS2_PLACEMENT_3D('',#51,$,$);"
         "#51=CARTESIAN_POINT('',(1.,2.,3.,4.));",
         "#51 CARTESIAN_POINT: it has more than 3 coordinates"},
        {"#100=CIRCLE('',#50,1.);#50=AXIS2_PLACEMENT_3D('',#51,$,$);"
         "#51=CARTESIAN_POINT((1.,2.,3.));",
         "#51 CARTESIAN_POINT: argument 2 is missing, not a list"},
        {"#100=CIRCLE('',#50,1.);#50=AXIS2_PLACEMENT_3D('',#2,$,$);",
         "#2 DIRECTION: it is not of the type CARTESIAN_POINT"},
        {"#100=CIRCLE('',#50,1.);#50=AXIS2_PLACEMENT_3D('',#1,#51,$);"
         "#51=DIRECTION('',(0.,0.,0.));",
         "#51 DIRECTION: it has no length"},
        {"#100=CIRCLE('',#8,1.);", "#8 LINE: it is not a placement in space"},
        {"#100=CIRCLE('',#4);", "#100 CIRCLE: argument 3 is missing"},
        {"#100=CIRCLE('',#4,1.,2.);",
         "#100 CIRCLE: argument 4 is a real, not one that belongs"},
        {"#100=CIRCLE(#4,1.);", "#100 CIRCLE: argument 1 is a reference, not a string"},
        {"#100=CIRCLE('',#4,$);", "#100 CIRCLE: argument 3 is $, not a number"},
        {"#100=CIRCLE('',#4,-1.);", "#100 CIRCLE: its radius is -1; it must be positive"},
        {"#100=CIRCLE('',#400,1.);",
         "#100 CIRCLE: argument 2 refers to #400, which is missing"},
        {"#100=ELLIPSE('',#4,1.,0.);", "#100 ELLIPSE: its second half axis is 0"},
        {"#100=CARTESIAN_POINT('',(1.,2.,3.));", "it is not a curve that can be read"},
        {"#100=FANCY_CURVE('',#4);", "#100 FANCY_CURVE: it is not a curve that can be read"},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        const bool is_unsupported = k >= COUNT(cases) - 2;
        check_refusal(cases[k].data,
                      k == 0           ? BATTEN_BAD_ARGUMENT
                      : is_unsupported ? BATTEN_UNSUPPORTED
                                       : BATTEN_BAD_FORMAT,
                      cases[k].words);
    }
    check_refusal("#100=LINE('',#1,#7);", BATTEN_NOT_COMPATIBLE, "#100 LINE: it has no ends");
    check_refusal("#100=CIRCLE('',#4,1E400);", BATTEN_OVERFLOW, "too large for a double");
}

TEST(step_circles_and_ellipses_are_whole_and_exact)
{
    const bat_step_scale inches = {25.4, 1, 1e-6};
    batten_curve *circle = curve_of("#100=CIRCLE('',#4,2.);", &inches, 0);
    for (int i = 0; i <= 20; i++) {
        double p[3];
        const batten_interval domain = batten_curve_domain(circle);
        CHECK_OK(
            batten_curve_evaluate(circle, domain.a + i / 20.0 * (domain.b - domain.a), 0, p));
        CHECK_NEAR(hypot(p[0] - 25.4, p[1] - 50.8), 50.8, 1e-13);
        CHECK_NEAR(p[2], 76.2, 1e-13);
    }
    check_at(circle, 0, 25.4, 101.6, 76.2);
    check_at(circle, 0.25, 25.4 - 50.8, 50.8, 76.2); /* y = z x x points along -X */
    batten_curve_unref(circle);
    batten_curve *surface = curve_of("#100=SEAM_CURVE('',#101,(#8),.CURVE_3D.);"
                                     "#101=SURFACE_CURVE('',#10,(),.CURVE_3D.);",
                                     &millimetres, 0);
    check_at(surface, 0, 1, 6, 3);
    check_at(surface, 0.25, -1, 2, 3);
    batten_curve_unref(surface);
}

/* 5 sqrt(1/2): the corner of the square in the circle #9. */
#define DIAGONAL 3.5355339059327378

/* Every way to trim, and three points of what it leaves. */
static const struct {
    const char *data;
    double start[3], middle[3], end[3];
} trims[] = {
    {"#100=TRIMMED_CURVE('',#9,(PARAMETER_VALUE(0.)),(#6,PARAMETER_VALUE("
     "1.5707963267948966)),.T.,.PARAMETER.);",
     {1, 7, 3},
     {1 - DIAGONAL, 2 + DIAGONAL, 3},
     {-4, 2, 3}},
    {"#100=TRIMMED_CURVE('',#9,(#5),(#6),.T.,.CARTESIAN.);",
     {1, 7, 3},
     {1 - DIAGONAL, 2 + DIAGONAL, 3},
     {-4, 2, 3}},
    {"#100=TRIMMED_CURVE('',#9,(#5,PARAMETER_VALUE(1.)),(PARAMETER_VALUE(2.),#6),.T.,"
     ".CARTESIAN.);",
     {1, 7, 3},
     {1 - DIAGONAL, 2 + DIAGONAL, 3},
     {-4, 2, 3}},
    {"#100=TRIMMED_CURVE('',#9,(#5),(#6),.F.,.UNSPECIFIED.);",
     {1, 7, 3},
     {1 + DIAGONAL, 2 - DIAGONAL, 3},
     {-4, 2, 3}},
    {"#100=TRIMMED_CURVE('',#9,(#6),(#5),.F.,.CARTESIAN.);",
     {-4, 2, 3},
     {1 - DIAGONAL, 2 + DIAGONAL, 3},
     {1, 7, 3}},
    {"#100=TRIMMED_CURVE('',#9,(PARAMETER_VALUE(-3.141592653589793)),(PARAMETER_VALUE("
     "9.42477796076938)),.T.,.PARAMETER.);",
     {1, -3, 3},
     {1, 7, 3},
     {1, -3, 3}},
    {"#100=TRIMMED_CURVE('',#15,(PARAMETER_VALUE(1.)),(PARAMETER_VALUE(4.)),.T.,.PARAMETER."
     ");",
     {3, 2, 3},
     {6, 2, 3},
     {9, 2, 3}},
    {"#100=TRIMMED_CURVE('',#15,(4.),(1.),.F.,.PARAMETER.);", {9, 2, 3}, {6, 2, 3}, {3, 2, 3}},
    {"#100=TRIMMED_CURVE('',#15,(#16),(#1),.F.,.CARTESIAN.);",
     {4, 2, 3},
     {2.5, 2, 3},
     {1, 2, 3}},
    {"#100=TRIMMED_CURVE('',#11,(PARAMETER_VALUE(-1.)),(PARAMETER_VALUE(3.)),.T.,"
     ".PARAMETER.);",
     {1 + 1, 2 + 0.5, 3},
     {1 - 1, 2 + 0.5, 3},
     {1 - 3, 2 + 4.5, 3}},
    {"#100=TRIMMED_CURVE('',#12,(PARAMETER_VALUE(-1.)),(PARAMETER_VALUE(1.)),.T.,"
     ".PARAMETER.);",
     {5.7008047745751984, 2 + 4.6292419044457313, 3},
     {1, 5, 3},
     {-3.7008047745751984, 2 + 4.6292419044457313, 3}},
    {"#100=TRIMMED_CURVE('',#20,(PARAMETER_VALUE(0.5)),(PARAMETER_VALUE(1.5)),.T.,"
     ".PARAMETER.);#20=POLYLINE('',(#1,#5,#6));",
     {1, 4.5, 3},
     {1, 7, 3},
     {-1.5, 4.5, 3}},
    {"#100=TRIMMED_CURVE('',#20,(#16),(#1),.F.,.CARTESIAN.);#20=POLYLINE('',(#1,#16,#6));",
     {4, 2, 3},
     {2.5, 2, 3},
     {1, 2, 3}},
};

TEST(step_trimmed_curves_run_between_their_ends)
{
    for (int k = 0; k < COUNT(trims); k++) {
        batten_curve *curve = curve_of(trims[k].data, &millimetres, 0);
        check_at(curve, 0, trims[k].start[0], trims[k].start[1], trims[k].start[2]);
        check_at(curve, 0.5, trims[k].middle[0], trims[k].middle[1], trims[k].middle[2]);
        check_at(curve, 1, trims[k].end[0], trims[k].end[1], trims[k].end[2]);
        batten_curve_unref(curve);
    }
}

/* A square from (1, 2, 3) on, sides of 3, 4, 3 and 4; parameters count its corners. */
#define SQUARE                                                                                   \
    "#21=CARTESIAN_POINT('',(4.,6.,3.));#22=CARTESIAN_POINT('',(1.,6.,3.));#20=POLYLINE('',(#1," \
    "#16,#21,#22,#1));"

/* Against the sense, over the end of what is closed, and both; the sense that the order of the ends has wins. */
static const struct {
    const char *data;
    double start[3], end[3];
    double length;
} spline_parts[] = {
    {SQUARE "#100=TRIMMED_CURVE('',#20,(0.5),(2.),.T.,.PARAMETER.);",
     {2.5, 2, 3},
     {4, 6, 3},
     5.5},
    {SQUARE "#100=TRIMMED_CURVE('',#20,(2.),(0.5),.F.,.PARAMETER.);",
     {4, 6, 3},
     {2.5, 2, 3},
     5.5},
    {SQUARE "#100=TRIMMED_CURVE('',#20,(3.5),(0.5),.T.,.PARAMETER.);",
     {1, 4, 3},
     {2.5, 2, 3},
     3.5},
    {SQUARE "#100=TRIMMED_CURVE('',#20,(0.5),(3.5),.F.,.PARAMETER.);",
     {2.5, 2, 3},
     {1, 4, 3},
     3.5},
    {SQUARE "#100=TRIMMED_CURVE('',#20,(0.),(4.),.T.,.PARAMETER.);", {1, 2, 3}, {1, 2, 3}, 14},
    {"#20=POLYLINE('',(#1,#16,#6));#100=TRIMMED_CURVE('',#20,(1.),(0.),.T.,.PARAMETER.);",
     {4, 2, 3},
     {1, 2, 3},
     3},
    {"#20=POLYLINE('',(#1,#16,#6));#100=TRIMMED_CURVE('',#20,(0.),(1.),.F.,.PARAMETER.);",
     {1, 2, 3},
     {4, 2, 3},
     3},
};

TEST(parts_of_splines_run_either_way_and_over_the_ends_of_closed_ones)
{
    for (int k = 0; k < COUNT(spline_parts); k++) {
        batten_curve *curve = curve_of(spline_parts[k].data, &millimetres, 0);
        double length = 0, error = 0;
        check_at(curve, 0, spline_parts[k].start[0], spline_parts[k].start[1],
                 spline_parts[k].start[2]);
        check_at(curve, 1, spline_parts[k].end[0], spline_parts[k].end[1],
                 spline_parts[k].end[2]);
        CHECK_OK(batten_curve_length(curve, 1e-12, &error, &length));
        CHECK_NEAR(length, spline_parts[k].length, 1e-11);
        batten_curve_unref(curve);
    }
}

TEST(parts_of_splines_beyond_their_domain_are_refused_with_both_ranges)
{
    check_refusal(SQUARE "#100=TRIMMED_CURVE('',#20,(-0.5),(2.),.T.,.PARAMETER.);",
                  BATTEN_OUT_OF_DOMAIN,
                  "#20 POLYLINE: the part from -0.5 to 2 is not in its domain from 0 to 4");
    check_refusal(SQUARE "#100=TRIMMED_CURVE('',#20,(1.),(4.5),.T.,.PARAMETER.);",
                  BATTEN_OUT_OF_DOMAIN,
                  "the part from 1 to 4.5 is not in its domain from 0 to 4");
    check_refusal(SQUARE "#100=TRIMMED_CURVE('',#20,(4.5),(1.),.F.,.PARAMETER.);",
                  BATTEN_OUT_OF_DOMAIN,
                  "the part from 4.5 to 1 is not in its domain from 0 to 4");
}

TEST(P6_degrees_rule_the_parameters_of_conics_alone)
{
    const bat_step_scale degrees = {1, 0.017453292519943295, 1e-6};
    batten_curve *arc = curve_of("#100=TRIMMED_CURVE('',#9,(PARAMETER_VALUE(90.)),"
                                 "(PARAMETER_VALUE(180.)),.T.,.PARAMETER.);",
                                 &degrees, 0);
    check_at(arc, 0, -4, 2, 3);
    check_at(arc, 1, 1, -3, 3);
    batten_curve_unref(arc);
    batten_curve *line = curve_of("#100=TRIMMED_CURVE('',#15,(PARAMETER_VALUE(0.)),"
                                  "(PARAMETER_VALUE(90.)),.T.,.PARAMETER.);",
                                  &degrees, 0);
    check_at(line, 1, 181, 2, 3);
    batten_curve_unref(line);
}

TEST(P2_bad_trims_are_refused)
{
    check_refusal("#100=TRIMMED_CURVE('',#9,(#5),(PARAMETER_VALUE(1.)),.T.,.CARTESIAN.);",
                  BATTEN_BAD_FORMAT, "neither two points nor two parameters");
    check_refusal("#100=TRIMMED_CURVE('',#9,(),(),.T.,.CARTESIAN.);", BATTEN_BAD_FORMAT,
                  "neither two points nor two parameters");
    check_refusal("#100=TRIMMED_CURVE('',#15,(1.),(1.),.T.,.PARAMETER.);", BATTEN_COINCIDENT,
                  "#15 LINE: the part of the conic from 1 to 1 has no length");
    check_refusal("#100=TRIMMED_CURVE('',#9,('a'),(1.),.T.,.PARAMETER.);", BATTEN_BAD_FORMAT,
                  "an item of argument 3 is a string, not a number");
    check_refusal(
        "#100=TRIMMED_CURVE('',#20,(0.),(5.),.T.,.PARAMETER.);#20=POLYLINE('',(#1,#5));",
        BATTEN_OUT_OF_DOMAIN, "the part from 0 to 5 is not in its domain from 0 to 1");
}

/* The quarter of a circle as a rational quadratic, its parts in three orders. */
TEST(P4_rational_curves_are_read_in_any_order_of_parts)
{
    const char *const parts[] = {"BOUNDED_CURVE()",
                                 "B_SPLINE_CURVE(2,(#30,#31,#32),.UNSPECIFIED.,.F.,.F.)",
                                 "B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)",
                                 "CURVE()",
                                 "GEOMETRIC_REPRESENTATION_ITEM()",
                                 "RATIONAL_B_SPLINE_CURVE((1.,0.7071067811865476,1.))",
                                 "REPRESENTATION_ITEM('')"};
    for (int k = 0; k < COUNT(parts); k++) {
        char data[700] =
            "#30=CARTESIAN_POINT('',(2.,0.,1.));#31=CARTESIAN_POINT('',(2.,2.,1.));"
            "#32=CARTESIAN_POINT('',(0.,2.,1.));#100=(";
        for (int i = 0; i < COUNT(parts); i++)
            strcat(strcat(data, i % 2 ? "\n " : ""), parts[(3 * i + k) % COUNT(parts)]);
        strcat(data, ");");
        batten_curve *curve = curve_of(data, &millimetres, 0);
        CHECK(batten_curve_is_rational(curve));
        check_at(curve, 0.5, sqrt(2), sqrt(2), 1);
        batten_curve_unref(curve);
    }
}

#define POINTS                                                               \
    "#30=CARTESIAN_POINT('',(0.,0.,0.));#31=CARTESIAN_POINT('',(1.,2.,0.));" \
    "#32=CARTESIAN_POINT('',(3.,2.,0.));#33=CARTESIAN_POINT('',(4.,0.,1.));" \
    "#34=CARTESIAN_POINT('',(6.,1.,0.));"

/* The knots of a curve of degree 2 through the same five points, by kind. */
TEST(step_splines_have_the_knots_of_their_kind)
{
    const struct {
        const char *data;
        double knots[8];
    } cases[] = {
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#32,#33,#34),.UNSPECIFIED.,.F.,.F.,"
         "(3,1,1,3),(0.,0.25,2.,7),.UNSPECIFIED.);",
         {0, 0, 0, 0.25, 2, 7, 7, 7}},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#32,#33,#34),.UNSPECIFIED.,.F.,.U.,"
         "(3,1,1,1,2),(0.,0.25,0.25,7,7),.UNSPECIFIED.);",
         {0, 0, 0, 0.25, 0.25, 7, 7, 7}},
        {"#100=BEZIER_CURVE('',2,(#30,#31,#32,#33,#34),.UNSPECIFIED.,.F.,.F.);",
         {0, 0, 0, 1, 1, 2, 2, 2}},
        {"#100=QUASI_UNIFORM_CURVE('',2,(#30,#31,#32,#33,#34),.UNSPECIFIED.,.F.,.F.);",
         {0, 0, 0, 1, 2, 3, 3, 3}},
        {"#100=UNIFORM_CURVE('',2,(#30,#31,#32,#33,#34),.UNSPECIFIED.,.F.,.F.);",
         {-2, -1, 0, 1, 2, 3, 4, 5}},
        {"#100=(UNIFORM_CURVE()B_SPLINE_CURVE(2,(#30,#31,#32,#33,#34),.UNSPECIFIED.,.F.,.F.)"
         "RATIONAL_B_SPLINE_CURVE((3.,3.,3.,3.,3.)));",
         {-2, -1, 0, 1, 2, 3, 4, 5}},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        char data[900];
        snprintf(data, sizeof data, "%s%s", POINTS, cases[k].data);
        batten_curve *curve = curve_of(data, &millimetres, 0);
        CHECK(!batten_curve_is_rational(curve)); /* also when all weights are 3 */
        CHECK_INT(batten_curve_knot_count(curve), 8);
        for (int i = 0; i < 8; i++)
            CHECK_BITS(batten_curve_knots(curve)[i], cases[k].knots[i]);
        CHECK_BITS(batten_curve_points(curve)[9], 4.0);
        batten_curve_unref(curve);
    }
}

TEST(P3_inconsistent_splines_are_refused_with_both_numbers)
{
    const struct {
        const char *data;
        batten_status status;
        const char *words;
    } cases[] = {
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#32,#33),.U.,.F.,.F.,(3,2),(0.,1.),.U.)"
         ";",
         BATTEN_BAD_KNOTS, "#100 B_SPLINE_CURVE_WITH_KNOTS: multiplicities sum to 5, need 7"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#32,#33),.U.,.F.,.F.,(3,2147483647),"
         "(0.,1.),.U.);",
         BATTEN_BAD_KNOTS, "multiplicities sum to 2147483650, need 7"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#32,#33),.U.,.F.,.F.,(3,1,3),(0.,1.),.U."
         ");",
         BATTEN_BAD_FORMAT, "it has 2 knots and 3 multiplicities"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#32),.U.,.F.,.F.,(3,-3),(0.,1.),.U.);",
         BATTEN_BAD_FORMAT, "multiplicity 2 is -3"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#32),.U.,.F.,.F.,(3,3),(1.,0.),.U.);",
         BATTEN_BAD_KNOTS, "knot 2 is 0, below the one before, which is 1"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',1,(#30,#31,#32,#33),.U.,.F.,.F.,(2,2,2),(0.,1.,2.),"
         ".U.)"
         ";",
         BATTEN_BAD_KNOTS, "#100 B_SPLINE_CURVE_WITH_KNOTS: "},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',0,(#30,#31,#32),.U.,.F.,.F.,(3,3),(0.,1.),.U.);",
         BATTEN_BAD_DEGREE, "its degree is 0; 1 to 25"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',26,(#30,#31,#32),.U.,.F.,.F.,(3,3),(0.,1.),.U.);",
         BATTEN_BAD_DEGREE, "its degree is 26; 1 to 25"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',25,(#30,#31,#32),.U.,.F.,.F.,(3,3),(0.,1.),.U.);",
         BATTEN_TOO_FEW_POINTS, "3 points are too few for degree 25"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',3,(#30,#31,#32),.U.,.F.,.F.,(3,3),(0.,1.),.U.);",
         BATTEN_TOO_FEW_POINTS, "3 points are too few for degree 3"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(),.U.,.F.,.F.,(3,3),(0.,1.),.U.);",
         BATTEN_TOO_FEW_POINTS, "0 points are too few"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#4),.U.,.F.,.F.,(3,3),(0.,1.),.U.);",
         BATTEN_BAD_FORMAT, "#4 AXIS2_PLACEMENT_3D: it is not of the type CARTESIAN_POINT"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS(2,(#30,#31,#32),.U.,.F.,.F.,(3,3),(0.,1.),.U.);",
         BATTEN_BAD_FORMAT, "argument 1 is an integer, not a string"},
        {"#100=B_SPLINE_CURVE_WITH_KNOTS('',2,(#30,#31,#32),.U.,.F.,.F.,(3,3),(0.,1.));",
         BATTEN_BAD_FORMAT, "argument 9 is missing"},
        {"#100=BEZIER_CURVE('',2,(#30,#31,#32,#33),.U.,.F.,.F.);", BATTEN_BAD_FORMAT,
         "4 points do not make a whole number of Bezier pieces of degree 2"},
        {"#100=(BEZIER_CURVE()B_SPLINE_CURVE(2,(#30,#31,#32),.U.,.F.,.F.)"
         "RATIONAL_B_SPLINE_CURVE((1.,2.)));",
         BATTEN_BAD_FORMAT, "#100 RATIONAL_B_SPLINE_CURVE: it has 2 weights for 3 points"},
        {"#100=(BEZIER_CURVE()B_SPLINE_CURVE(2,(#30,#31,#32),.U.,.F.,.F.)"
         "RATIONAL_B_SPLINE_CURVE((1.,0.,1.)));",
         BATTEN_BAD_WEIGHT, "#100 RATIONAL_B_SPLINE_CURVE: "},
        {"#100=(BEZIER_CURVE()B_SPLINE_CURVE(2,(#30,#31,#32),.U.,.F.,.F.)"
         "RATIONAL_B_SPLINE_CURVE((-1.,-1.,-1.)));",
         BATTEN_BAD_WEIGHT, ""},
        {"#100=(BEZIER_CURVE()RATIONAL_B_SPLINE_CURVE((1.,1.,1.)));", BATTEN_BAD_FORMAT,
         "it has no part B_SPLINE_CURVE"},
        {"#100=(BEZIER_CURVE()B_SPLINE_CURVE('',2,(#30,#31,#32),.U.,.F.,.F.));",
         BATTEN_BAD_FORMAT, "its part B_SPLINE_CURVE has 6 arguments, not 5"},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        char data[900];
        snprintf(data, sizeof data, "%s%s", POINTS, cases[k].data);
        check_refusal(data, cases[k].status, cases[k].words);
    }
}

TEST(step_composite_curves_run_head_to_tail)
{
    batten_curve *curve =
        curve_of("#20=POLYLINE('',(#1,#5));#21=TRIMMED_CURVE('',#9,(#5),(#6),.T.,.CARTESIAN.);"
                 "#22=POLYLINE('',(#16,#6));"
                 "#40=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#20);"
                 "#41=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#21);"
                 "#42=COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.,.F.,#22);"
                 "#100=COMPOSITE_CURVE('',(#40,#41,#42),.U.);",
                 &millimetres, 0);
    check_at(curve, 0, 1, 2, 3);
    check_at(curve, 1, 4, 2, 3);
    CHECK_INT(batten_curve_degree(curve), 2);
    batten_curve_unref(curve);
    check_refusal("#40=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#20);#20=POLYLINE('',(#1,#5));"
                  "#41=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#22);#22=POLYLINE('',(#16,#6));"
                  "#100=COMPOSITE_CURVE('',(#40,#41),.U.);",
                  BATTEN_NOT_COMPATIBLE, "#100 COMPOSITE_CURVE: ");
    check_refusal("#100=COMPOSITE_CURVE('',(),.U.);", BATTEN_BAD_FORMAT, "it has no segments");
    check_refusal("#100=COMPOSITE_CURVE('',(#1),.U.);", BATTEN_BAD_FORMAT,
                  "#1 CARTESIAN_POINT: it is not a segment");
}

TEST(P1_rings_of_curves_are_refused)
{
    check_refusal("#100=TRIMMED_CURVE('',#100,(0.),(1.),.T.,.PARAMETER.);", BATTEN_UNSUPPORTED,
                  "#100 TRIMMED_CURVE");
    check_refusal("#100=TRIMMED_CURVE('',#101,(#1),(#5),.T.,.CARTESIAN.);"
                  "#101=TRIMMED_CURVE('',#100,(#1),(#5),.T.,.CARTESIAN.);",
                  BATTEN_BAD_FORMAT, "it stands on itself, or more than 64 deep on others");
    check_refusal("#100=SURFACE_CURVE('',#100,(),.CURVE_3D.);", BATTEN_BAD_FORMAT,
                  "it stands on itself");
    check_refusal("#40=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#100);"
                  "#100=COMPOSITE_CURVE('',(#40,#40),.U.);",
                  BATTEN_BAD_FORMAT, "it stands on itself");
}

/* Sixty levels, each of which stands twice on the one below: refused without the work. */
TEST(S1_a_curve_that_doubles_at_every_level_is_refused)
{
    char *data = test_array(10000, 1), *to = data;
    to += sprintf(to, "#200=POLYLINE('',(#1,#5));");
    for (int k = 1; k <= 50; k++)
        to += sprintf(to,
                      "#%d=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#%d);"
                      "#%d=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,#%d);"
                      "#%d=COMPOSITE_CURVE('',(#%d,#%d),.U.);",
                      300 + k, 199 + k, 400 + k, 199 + k, 200 + k, 300 + k, 400 + k);
    sprintf(to, "#100=COMPOSITE_CURVE('',(#350,#450),.U.);");
    check_refusal(data, BATTEN_TOO_LARGE, "is one reference too many");
}

TEST(step_offset_curves_go_along_v_cross_t)
{
    batten_curve *curve = curve_of("#100=OFFSET_CURVE_3D('',#9,2.,.F.,#2);", &millimetres, 0);
    const batten_interval domain = batten_curve_domain(curve);
    for (int i = 0; i <= 20; i++) {
        double p[3];
        CHECK_OK(
            batten_curve_evaluate(curve, domain.a + i / 20.0 * (domain.b - domain.a), 0, p));
        CHECK_NEAR(hypot(p[0] - 1, p[1] - 2), 3, 1e-6); /* counter-clockwise: it shrinks */
    }
    batten_curve_unref(curve);
}

#define NET                                                                  \
    "#30=CARTESIAN_POINT('',(0.,0.,0.));#31=CARTESIAN_POINT('',(0.,3.,0.));" \
    "#32=CARTESIAN_POINT('',(4.,0.,0.));#33=CARTESIAN_POINT('',(4.,3.,2.));" \
    "#50=BEZIER_SURFACE('',1,1,((#30,#31),(#32,#33)),.U.,.F.,.F.,.F.);"      \
    "#51=PCURVE('',#50,#52);#52=DEFINITIONAL_REPRESENTATION('',(#53),$);"    \
    "#53=POLYLINE('',(#54,#55));#54=CARTESIAN_POINT('',(0.,0.5));"           \
    "#55=CARTESIAN_POINT('',(1.,0.5));"

TEST(step_curves_in_parameters_lie_on_their_spline_surface)
{
    batten_curve *curve = curve_of(NET "#100=PCURVE('',#50,#52);", &millimetres, 0);
    check_at(curve, 0, 0, 1.5, 0);
    check_at(curve, 0.5, 2, 1.5, 0.5);
    check_at(curve, 1, 4, 1.5, 1);
    batten_curve_unref(curve);
    step_text_file t = {.notes = NULL};
    batten_curve *flat = NULL, *none = NULL;
    const bat_step_scale inches = {25.4, 1, 1e-6};
    CHECK_OK(step_begin(&t, step_whole(COMMON NET
                                       "#60=PLANE('',#4);"
                                       "#100=SURFACE_CURVE('',#8,(#60,#51),.CURVE_3D.);")));
    CHECK_OK(
        bat_step_read_pcurve(&t.file, step_find(&t, 100), step_find(&t, 50), &inches, &flat));
    CHECK_INT(batten_curve_dimension(flat), 2);
    CHECK_BITS(batten_curve_points(flat)[1], 0.5); /* no length */
    CHECK_OK(
        bat_step_read_pcurve(&t.file, step_find(&t, 100), step_find(&t, 60), &inches, &none));
    CHECK(none == NULL);
    batten_curve_unref(flat);
    step_end(&t);
}
