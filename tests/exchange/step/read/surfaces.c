#include "support/surfaces.h"
#include "exchange/step/read/surface_text.h"

#include <batten/measure.h>

TEST(step_nets_are_rows_along_v)
{
    const bat_step_scale inches = {25.4, 1, 1e-6};
    batten_surface *surface =
        surface_of(NET "#100=B_SPLINE_SURFACE_WITH_KNOTS('',2,2," ROWS
                       ",.UNSPECIFIED.,.F.,.F.,.U.,(3,3),(3,1,3),(0.,1.),(0.,0.5,3),.U.);",
                   &inches);
    const double knots[] = {0, 0, 0, 0.5, 3, 3, 3};
    CHECK_INT(batten_surface_point_count(surface, BATTEN_U), 3);
    CHECK_INT(batten_surface_point_count(surface, BATTEN_V), 4);
    for (int i = 0; i < 7; i++)
        CHECK_BITS(batten_surface_knots(surface, BATTEN_V)[i], knots[i]);
    CHECK_BITS(batten_surface_points(surface)[3 * 5 + 2], 4 * 25.4);
    CHECK_BITS(batten_surface_points(surface)[3 * 11], 5 * 25.4);
    CHECK(!batten_surface_is_rational(surface));
    batten_surface_unref(surface);
}

/* A quarter of a cylinder of radius 20, as the specification of exchange shows it. */
TEST(P4_rational_surfaces_are_read_in_any_order_of_parts)
{
    const char *const parts[] = {
        "BOUNDED_SURFACE()",
        "B_SPLINE_SURFACE(2,1,((#30,#31),(#32,#33),(#34,#35)),.UNSPECIFIED.,.F.,.F.,.F.)",
        "B_SPLINE_SURFACE_WITH_KNOTS((3,3),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)",
        "GEOMETRIC_REPRESENTATION_ITEM()",
        "RATIONAL_B_SPLINE_SURFACE(((1.,1.),(0.7071067811865476,0.7071067811865476),(1.,1.)))",
        "REPRESENTATION_ITEM('')",
        "SURFACE()"};
    for (int k = 0; k < COUNT(parts); k++) {
        char data[1200] =
            "#30=CARTESIAN_POINT('',(20.,0.,0.));#31=CARTESIAN_POINT('',(20.,0.,30.));"
            "#32=CARTESIAN_POINT('',(20.,20.,0.));#33=CARTESIAN_POINT('',(20.,20.,30.));"
            "#34=CARTESIAN_POINT('',(0.,20.,0.));#35=CARTESIAN_POINT('',(0.,20.,30.));#100=(";
        for (int i = 0; i < COUNT(parts); i++)
            strcat(data, parts[(3 * i + k) % COUNT(parts)]);
        strcat(data, ");");
        batten_surface *surface = surface_of(data, &millimetres);
        for (int i = 0; i <= 8; i++) {
            double at[3][3];
            evaluate(surface, i / 8.0, 0.5, at);
            CHECK_NEAR(hypot(at[0][0], at[0][1]), 20, 1e-14);
            CHECK_NEAR(at[0][2], 15, 1e-14);
        }
        batten_surface_unref(surface);
    }
}

TEST(P3_inconsistent_nets_are_refused_with_both_numbers)
{
#define KNOTS ",.U.,.F.,.F.,.F.,(3,3),(3,1,3),(0.,1.),(0.,1.,2.),.U.);"
    const struct {
        const char *data;
        batten_status status;
        const char *words;
    } cases[] = {
        {"#100=B_SPLINE_SURFACE_WITH_KNOTS('',2,2,((#30,#31,#32,#33),(#34,#35),(#38))" KNOTS,
         BATTEN_BAD_FORMAT, "row 2 has 2 points, row 1 has 4"},
        {"#100=B_SPLINE_SURFACE_WITH_KNOTS('',2,2,((#30,#31),(#34,#35),(#38,#39,#40,#41)"
         ")" KNOTS,
         BATTEN_BAD_FORMAT, "row 3 has 4 points, row 1 has 2"},
        {"#100=B_SPLINE_SURFACE_WITH_KNOTS('',2,2,()" KNOTS, BATTEN_TOO_FEW_POINTS,
         "it has no points"},
        {"#100=B_SPLINE_SURFACE_WITH_KNOTS('',2,2,((),(),())" KNOTS, BATTEN_TOO_FEW_POINTS,
         "0 points are too few for degree 2"},
        {"#100=B_SPLINE_SURFACE_WITH_KNOTS('',2,2,(#30,#31)" KNOTS, BATTEN_BAD_FORMAT,
         "an item of argument 4 is a reference, not a list"},
        {"#100=B_SPLINE_SURFACE_WITH_KNOTS('',2,3," ROWS KNOTS, BATTEN_BAD_KNOTS,
         "#100 B_SPLINE_SURFACE_WITH_KNOTS: multiplicities sum to 7, need 8"},
        {"#100=B_SPLINE_SURFACE_WITH_KNOTS('',2," ROWS KNOTS, BATTEN_BAD_FORMAT,
         "argument 13 is missing"},
        {"#100=(BEZIER_SURFACE()B_SPLINE_SURFACE(2,3," ROWS ",.U.,.F.,.F.,.F.)"
         "RATIONAL_B_SPLINE_SURFACE(((1.,1.,1.,1.),(1.,1.,1.,2.))));",
         BATTEN_BAD_FORMAT, "it has 2 rows of weights for 3 rows of points"},
        {"#100=(BEZIER_SURFACE()B_SPLINE_SURFACE(2,3," ROWS ",.U.,.F.,.F.,.F.)"
         "RATIONAL_B_SPLINE_SURFACE(((1.,1.,1.,1.),(1.,1.,1.),(1.,1.,1.,1.))));",
         BATTEN_BAD_FORMAT, "it has 3 weights for 4 points in a row"},
        {"#100=(BEZIER_SURFACE()B_SPLINE_SURFACE(2,3," ROWS ",.U.,.F.,.F.,.F.)"
         "RATIONAL_B_SPLINE_SURFACE(((1.,1.,1.,1.),(1.,-1.,1.,1.),(1.,1.,1.,1.))));",
         BATTEN_BAD_WEIGHT, "#100 RATIONAL_B_SPLINE_SURFACE: "},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        char data[1500];
        snprintf(data, sizeof data, "%s%s", NET, cases[k].data);
        check_refusal(data, cases[k].status, cases[k].words);
    }
}

/* What each kind is, in its frame, by its own formula; and where its normal points. */
typedef struct {
    const char *data;
    bat_elementary_kind kind;
    double a, b;
    bool is_reversed;
} elementary_case;

TEST(step_elementary_surfaces_are_named_with_their_measures)
{
    const double degree = 0.017453292519943295;
    const elementary_case cases[] = {
        {"#100=PLANE('',#4);", BAT_PLANE, 0, 0, false},
        {"#100=CYLINDRICAL_SURFACE('',#4,2.);", BAT_CYLINDER, 50.8, 0, false},
        {"#100=CONICAL_SURFACE('',#4,0.,30.);", BAT_CONE, 0, 30 * degree, false},
        {"#100=SPHERICAL_SURFACE('',#4,2.);", BAT_SPHERE, 50.8, 0, false},
        {"#100=TOROIDAL_SURFACE('',#4,3.,2.);", BAT_TORUS, 76.2, 50.8, false},
        {"#100=DEGENERATE_TOROIDAL_SURFACE('',#4,1.,2.,.T.);", BAT_TORUS, 25.4, 50.8, false},
        {"#100=SURFACE_OF_LINEAR_EXTRUSION('',#10,#7);", BAT_PLANE, 0, 0, false},
        {"#100=SURFACE_OF_LINEAR_EXTRUSION('',#20,#7);", BAT_EXTRUSION, 0, 0, false},
        {"#100=SURFACE_OF_REVOLUTION('',#20,#5);", BAT_REVOLUTION, 0, 0, false},
        {"#100=SURFACE_OF_REVOLUTION('',#8,#5);", BAT_CYLINDER, 4 * 25.4, 0, false},
        {"#100=SURFACE_OF_REVOLUTION('',#13,#5);", BAT_CYLINDER, 4 * 25.4, 0, true},
        {"#100=SURFACE_OF_REVOLUTION('',#16,#5);", BAT_CONE, 4 * 25.4, 0.6435011087932844,
         false},
        {"#100=SURFACE_OF_REVOLUTION('',#10,#5);", BAT_PLANE, 4 * 25.4, 0, false},
        {"#100=SURFACE_OF_REVOLUTION('',#60,#5);#60=LINE('',#1,#15);", BAT_CONE, 0,
         0.6435011087932844, false},
        {"#100=OFFSET_SURFACE('',#50,1.,.F.);#50=SPHERICAL_SURFACE('',#4,2.);", BAT_SPHERE,
         76.2, 0, false},
        {"#100=OFFSET_SURFACE('',#50,-1.,.F.);#50=SURFACE_OF_REVOLUTION('',#13,#5);",
         BAT_CYLINDER, 5 * 25.4, 0, true},
        {"#100=OFFSET_SURFACE('',#50,3.,.F.);#50=CONICAL_SURFACE('',#4,1.,60.);", BAT_CONE,
         7 * 25.4, 60 * degree, false},
        {"#100=OFFSET_SURFACE('',#50,2.,.F.);#50=BEZIER_SURFACE('',2,3," ROWS
         ",.U.,.F.,.F.,.F.);" NET,
         BAT_OFFSET_SURFACE, 50.8, 0, false},
    };
    const bat_step_scale odd = {25.4, degree, 1e-6};
    for (int k = 0; k < COUNT(cases); k++) {
        step_text_file t = {.notes = NULL};
        bat_elementary e;
        bat_step_basis basis;
        bool is_elementary = false;
        CHECK_OK(step_begin(&t, with_common(cases[k].data)));
        CHECK_OK(bat_step_as_elementary(&t.file, step_find(&t, 100), &odd, &e, &basis,
                                        &is_elementary));
        CHECK(is_elementary);
        CHECK_INT(e.kind, cases[k].kind);
        CHECK_NEAR(e.a, cases[k].a, 1e-13);
        CHECK_NEAR(e.b, cases[k].b, 1e-15 + 1e-15 * cases[k].b);
        CHECK(basis.is_reversed == cases[k].is_reversed);
        bat_step_basis_end(&basis);
        step_end(&t);
    }
    step_text_file t = {.notes = NULL};
    bat_elementary e;
    bat_step_basis basis;
    bool is_elementary = true;
    CHECK_OK(step_begin(&t, with_common("#100=FANCY('');")));
    CHECK_OK(
        bat_step_as_elementary(&t.file, step_find(&t, 100), &odd, &e, &basis, &is_elementary));
    CHECK(!is_elementary);
    step_end(&t);
}

/* Its outer part or its inner one; areas by Pappus. */
TEST(a_degenerate_torus_alone_is_the_part_that_it_selects)
{
    for (int outer = 0; outer < 2; outer++) {
        batten_surface *part =
            surface_of(outer ? "#100=DEGENERATE_TOROIDAL_SURFACE('',#4,1.,2.,.T.);"
                             : "#100=DEGENERATE_TOROIDAL_SURFACE('',#4,1.,2.,.F.);",
                       &millimetres);
        double area = 0, error = 0;
        const double turn = acos(outer ? -0.5 : 0.5);
        CHECK_OK(test_surface_area(part, 1e-10, &area, &error));
        CHECK_NEAR(area, 8 * BAT_PI * ((outer ? 1 : -1) * turn + 2 * sin(turn)), 1e-8);
        batten_surface_unref(part);
    }
    check_refusal("#100=DEGENERATE_TOROIDAL_SURFACE('',#4,1.,2.,1);", BATTEN_BAD_FORMAT,
                  ".T. or .F.");
}

/* The same points; trimmed by the formula, with a + b cos v from the axis. */
TEST(a_torus_of_negative_major_radius_is_taken_as_its_formula_has_it)
{
    batten_surface *torus = surface_of("#100=TOROIDAL_SURFACE('',#4,-5.,2.);", &millimetres);
    double area = 0, error = 0;
    CHECK_OK(test_surface_area(torus, 1e-10, &area, &error));
    CHECK_NEAR(area, 40 * BAT_PI * BAT_PI, 1e-6);
    batten_surface_unref(torus);
    batten_surface *part =
        surface_of("#100=RECTANGULAR_TRIMMED_SURFACE('',#101,0.,1.,0.,1.,.T.,.T.);"
                   "#101=TOROIDAL_SURFACE('',#4,-5.,2.);",
                   &millimetres);
    const double p[3] = {1, 2 - 3, 3};
    check_at(part, 0, 0, p);
    batten_surface_unref(part);
    check_refusal("#100=TOROIDAL_SURFACE('',#4,0.,2.);", BATTEN_BAD_FORMAT,
                  "its major radius is 0; it must be positive");
    check_refusal("#100=TOROIDAL_SURFACE('',#4,5.,-2.);", BATTEN_BAD_FORMAT,
                  "its minor radius is -2; it must be positive");
}

TEST(step_bounded_surfaces_stand_alone_and_unbounded_do_not)
{
    batten_surface *torus = surface_of("#100=TOROIDAL_SURFACE('',#4,5.,2.);", &millimetres);
    const double p[3] = {1, 2 + 7, 3};
    check_at(torus, 0, 0, p);
    batten_surface_unref(torus);
    /* Su x Sv: turned about z, the segment runs to the axis, so that the normal is z. */
    batten_surface *disc = surface_of("#100=SURFACE_OF_REVOLUTION('',#20,#5);", &millimetres);
    double at[3][3];
    evaluate(disc, 0, 0.5, at);
    CHECK_NEAR(at[0][1], 4, 1e-14);
    CHECK(at[1][0] * at[2][1] - at[1][1] * at[2][0] > 0);
    batten_surface_unref(disc);
    check_refusal("#100=PLANE('',#4);", BATTEN_NOT_COMPATIBLE, "#100 PLANE: ");
    check_refusal("#100=SURFACE_OF_LINEAR_EXTRUSION('',#20,#7);", BATTEN_NOT_COMPATIBLE,
                  "#100 SURFACE_OF_LINEAR_EXTRUSION: ");
}

TEST(P2_bad_surfaces_are_named)
{
    const struct {
        const char *data;
        batten_status status;
        const char *words;
    } cases[] = {
        {"#100=CYLINDRICAL_SURFACE('',#4,-2.);", BATTEN_BAD_FORMAT,
         "#100 CYLINDRICAL_SURFACE: its radius is -2; it must be positive"},
        {"#100=CONICAL_SURFACE('',#4,1.,90.);", BATTEN_BAD_FORMAT,
         "its half angle is too large"},
        {"#100=CONICAL_SURFACE('',#4,1.);", BATTEN_BAD_FORMAT, "argument 4 is missing"},
        {"#100=PLANE(#4);", BATTEN_BAD_FORMAT, "argument 1 is a reference, not a string"},
        {"#100=SURFACE_OF_REVOLUTION('',#19,#5);", BATTEN_UNSUPPORTED,
         "are skew: a hyperboloid"},
        {"#100=SURFACE_OF_LINEAR_EXTRUSION('',#8,#7);", BATTEN_BAD_FORMAT,
         "its line runs along its direction"},
        {"#100=SURFACE_OF_LINEAR_EXTRUSION('',#20,#5);", BATTEN_BAD_FORMAT,
         "#5 AXIS1_PLACEMENT: it is not a VECTOR"},
        {"#100=OFFSET_SURFACE('',#50,-3.,.F.);#50=SPHERICAL_SURFACE('',#4,2.);",
         BATTEN_BAD_FORMAT, "the distance -3 is more than the radius"},
        {"#100=RECTANGULAR_TRIMMED_SURFACE('',#50,0.,0.,0.,1.,.T.,.T.);#50=PLANE('',#4);",
         BATTEN_BAD_FORMAT, "its u runs from 0 to 0"},
        {"#100=RECTANGULAR_TRIMMED_SURFACE('',#50,1E100,2.,0.,1.,.T.,.T.);#50=PLANE('',#4);",
         BATTEN_BAD_FORMAT, "its u runs from 1e+100 to 2"},
        {"#100=RECTANGULAR_TRIMMED_SURFACE('',#50,1.,2.,7.,7.,.T.,.T.);#50=PLANE('',#4);",
         BATTEN_BAD_FORMAT, "its v runs from 7 to 7"},
        {"#100=RECTANGULAR_TRIMMED_SURFACE('',#50,1.,2.,3.,-1E100,.T.,.T.);#50=PLANE('',#4);",
         BATTEN_BAD_FORMAT, "its v runs from 3 to -1e+100"},
        {"#100=RECTANGULAR_TRIMMED_SURFACE('',#100,0.,1.,0.,1.,.T.,.T.);", BATTEN_UNSUPPORTED,
         "a part of such a surface"},
        {"#100=OFFSET_SURFACE('',#100,1.,.F.);", BATTEN_BAD_FORMAT, "it stands on itself"},
        {"#100=CIRCLE('',#4,1.);", BATTEN_UNSUPPORTED, "it is not a surface that can be read"},
    };
    for (int k = 0; k < COUNT(cases); k++)
        check_refusal(cases[k].data, cases[k].status, cases[k].words);
}
