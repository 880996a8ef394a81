/* The curves of IGES against what their formulas say. */
#include "exchange/iges/read/curves.h"

#include "exchange/iges/text.h"

#include <batten/measure.h>

static void point_at(const batten_curve *curve, double share, double p[3])
{
    const batten_interval domain = batten_curve_domain(curve);
    CHECK_OK(batten_curve_evaluate(curve, domain.a + share * (domain.b - domain.a), 0, p));
}

static void check_point(const batten_curve *curve, double share, double x, double y, double z)
{
    double p[3];
    point_at(curve, share, p);
    CHECK_NEAR(p[0], x, 1e-12);
    CHECK_NEAR(p[1], y, 1e-12);
    CHECK_NEAR(p[2], z, 1e-12);
}

/* The only curve of a file with one root. */
static batten_model *read_curve(iges_text *file, const char *note)
{
    batten_model *model = read_noting(iges_end(file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, note);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_CURVE);
    return model;
}

TEST(an_arc_runs_counter_clockwise_and_one_that_ends_where_it_begins_is_a_circle)
{
    static const struct {
        const char *text;
        double length, end[3], middle[3];
    } cases[] = {
        {"100,5.,1.,2.,3.,2.,1.,4.;", 1, {1, 4, 5}, {0, 0, 5}},
        {"100,0.,0.,0.,0.,2.,2.,0.;", 3, {2, 0, 0}, {0, 0, 0}},
        {"100,0.,0.,0.,-2.,0.,-2.,0.;", 4, {-2, 0, 0}, {2, 0, 0}},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 100, 0, 0, 0, "00000000", cases[i].text);
        batten_model *model = read_curve(&file, "");
        const batten_curve *curve = batten_model_object(model, 0)->curve;
        double length = 0;
        CHECK_OK(batten_curve_length(curve, 1e-10, NULL, &length));
        CHECK_NEAR(length, cases[i].length * 3.14159265358979323846, 1e-9);
        check_point(curve, 1, cases[i].end[0], cases[i].end[1], cases[i].end[2]);
        batten_model_unref(model);
    }
    iges_text bad = iges_begin();
    iges_add(&bad, 100, 0, 0, 0, "00000000", "100,0.,1.,1.,1.,1.,2.,1.;");
    iges_check_left_out(&bad, "an arc of radius 0");
    iges_text uneven = iges_begin();
    iges_add(&uneven, 100, 0, 0, 0, "00000000", "100,0.,0.,0.,1.,0.,0.,1.1;");
    batten_model_unref(read_curve(&uneven, "whose ends are 1 and 1.1 from its centre"));
}

TEST(a_composite_is_one_curve_through_its_members_also_nested_and_moved)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00010000", "110,0.,0.,0.,1.,0.,0.;");
    iges_add(&file, 100, 0, 0, 0, "00010000", "100,0.,1.,1.,1.,0.,2.,1.;");
    iges_add(&file, 102, 0, 9, 0, "00010000", "102,2,1,3;");
    iges_add(&file, 110, 0, 0, 0, "00010000", "110,2.,1.,3.,2.,5.,3.;");
    iges_add(&file, 124, 0, 0, 0, "00000000", "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,3.;");
    iges_add(&file, 116, 0, 0, 0, "00010000", "116,2.,1.,3.;");
    iges_add(&file, 102, 0, 0, 0, "00000000", "102,3,5,11,7;");
    batten_model *model = read_curve(&file, "");
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    double length = 0;
    CHECK_OK(batten_curve_length(curve, 1e-10, NULL, &length));
    CHECK_NEAR(length, 1 + 3.14159265358979323846 / 2 + 4, 1e-9);
    check_point(curve, 0, 0, 0, 3);
    check_point(curve, 1, 2, 5, 3);
    batten_model_unref(model);
}

TEST(Q6_a_composite_of_itself_of_nothing_or_with_gaps_is_left_out)
{
    static const struct {
        const char *text, *words;
    } cases[] = {{"102,1,1;", "entity D1 is a part of itself"},
                 {"102,0;", "it has 0 members"},
                 {"102,-1;", "parameter 1, a count, is -1"},
                 {"102,1000000000,3;", "3 parameters, need 1000000002"},
                 {"102,1,99;", "it refers to entity D99, which is missing"},
                 {"102,1,3;", "as a curve, which is a 124 matrix"},
                 {"102,1,4;", "4 is not the odd number"}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 102, 0, 0, 0, "00000000", cases[i].text);
        iges_add(&file, 124, 0, 0, 0, "00000000", "124,1.,,,,,1.,,,,,1.,;");
        iges_check_left_out(&file, cases[i].words);
    }
    iges_text gap = iges_begin();
    iges_add(&gap, 110, 0, 0, 0, "00010000", "110,0.,0.,0.,1.,0.,0.;");
    iges_add(&gap, 110, 0, 0, 0, "00010000", "110,1.5,0.,0.,2.,0.,0.;");
    iges_add(&gap, 102, 0, 0, 0, "00000000", "102,2,1,3;");
    iges_check_left_out(&gap, "0.5");
}

TEST(P1_a_ring_of_composites_is_left_out_once_each)
{
    iges_text file = iges_begin();
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    iges_add(&file, 102, 0, 0, 0, "00000000", "102,1,3;");
    iges_add(&file, 102, 0, 0, 0, "00000000", "102,1,1;");
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(model), 1);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "is a part of itself"));
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(S4_composites_nested_deeper_than_the_limit_are_refused)
{
    enum { DEEP = 200 };
    iges_text file = iges_begin();
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    char text[40];
    for (int i = 0; i < DEEP; i++) {
        snprintf(text, sizeof text, "102,1,%d;", 2 * i + 3);
        iges_add(&file, 102, 0, 0, 0, "00000000", text);
    }
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(model), 1);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "entities are nested more than 64 deep"));
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* The equation at many points of the curve, and its ends. */
static void check_conic(const char *text, int form, const double q[6], const double ends[4],
                        const char *note)
{
    iges_text file = iges_begin();
    iges_add(&file, 104, form, 0, 0, "00000000", text);
    batten_model *model = read_curve(&file, note);
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    for (int i = 0; i <= 50; i++) {
        double p[3];
        point_at(curve, i / 50.0, p);
        CHECK_NEAR(q[0] * p[0] * p[0] + q[1] * p[0] * p[1] + q[2] * p[1] * p[1] + q[3] * p[0] +
                       q[4] * p[1] + q[5],
                   0, 1e-10);
        CHECK_NEAR(p[2], 3, 1e-12);
    }
    check_point(curve, 0, ends[0], ends[1], 3);
    check_point(curve, 1, ends[2], ends[3], 3);
    batten_model_unref(model);
}

TEST(conics_fulfil_their_equation_and_run_from_start_to_end)
{
    const double ellipse[6] = {1, 0, 4, 0, 0, -4}, hyperbola[6] = {1, 0, -1, 0, 0, -1};
    const double parabola[6] = {1, 0, 0, 0, -1, 0}, turned[6] = {0, 1, 0, 0, 0, -1};
    const double moved[6] = {0, 0, 1, -4, -2, 1};
    check_conic("104,1.,0.,4.,0.,0.,-4.,3.,2.,0.,0.,1.;", 1, ellipse, (double[]){2, 0, 0, 1},
                "");
    check_conic("104,1.,0.,4.,0.,0.,-4.,3.,2.,0.,2.,0.;", 0, ellipse, (double[]){2, 0, 2, 0},
                "");
    check_conic("104,1.,0.,-1.,0.,0.,-1.,3.,1.25,.75,1.25,-.75;", 2, hyperbola,
                (double[]){1.25, .75, 1.25, -.75}, "");
    check_conic("104,1.,0.,-1.,0.,0.,-1.,3.,-1.25,.75,-1.25,-.75;", 0, hyperbola,
                (double[]){-1.25, .75, -1.25, -.75}, "");
    check_conic("104,1.,0.,0.,0.,-1.,0.,3.,-2.,4.,1.,1.;", 3, parabola, (double[]){-2, 4, 1, 1},
                "");
    check_conic("104,0.,1.,0.,0.,0.,-1.,3.,.5,2.,4.,.25;", 0, turned, (double[]){.5, 2, 4, .25},
                "");
    check_conic("104,0.,0.,1.,-4.,-2.,1.,3.,0.25,0.,1.,3.;", 0, moved,
                (double[]){0.25, 0, 1, 3}, "");
}

TEST(conics_that_are_none_are_left_out_and_wrong_forms_are_noted)
{
    static const char *const bad[] = {"104,0.,0.,0.,1.,1.,1.,0.,0.,0.,1.,1.;",
                                      "104,1.,0.,1.,0.,0.,1.,0.,0.,0.,1.,1.;"};
    for (int i = 0; i < COUNT(bad); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 104, 0, 0, 0, "00000000", bad[i]);
        iges_check_left_out(&file, "left out");
    }
    const double ellipse[6] = {1, 0, 4, 0, 0, -4};
    check_conic("104,1.,0.,4.,0.,0.,-4.,3.,2.,0.,0.,1.;", 2, ellipse, (double[]){2, 0, 0, 1},
                "it is declared a hyperbola");
}

TEST(a_conic_may_be_scaled_and_its_ends_are_put_onto_it_with_a_note)
{
    const double circle[6] = {1, 0, 1, 0, 0, -1};
    check_conic("104,1E200,0.,1E200,0.,0.,-1E200,3.,1.,0.,0.,1.;", 1, circle,
                (double[]){1, 0, 0, 1}, "");
    check_conic("104,1.,0.,1.,0.,0.,-1.,3.,3.,0.,0.,3.;", 1, circle, (double[]){1, 0, 0, 1},
                "a conic whose ends are 2 off its equation; the equation is used");
}

TEST(copious_data_are_points_polylines_and_loops)
{
    static const struct {
        const char *text;
        int form, points;
        double last[3];
    } cases[] = {
        {"106,1,2,7.,1.,2.,3.,4.;", 1, 2, {3, 4, 7}},
        {"106,2,2,1.,2.,3.,4.,5.,6.;", 2, 2, {4, 5, 6}},
        {"106,3,2,1.,2.,3.,0.,0.,1.,4.,5.,6.,0.,0.,1.;", 3, 2, {4, 5, 6}},
        {"106,1,3,7.,1.,2.,3.,4.,5.,6.;", 11, 0, {5, 6, 7}},
        {"106,2,2,1.,2.,3.,4.,5.,6.;", 12, 0, {4, 5, 6}},
        {"106,3,2,1.,2.,3.,0.,0.,1.,4.,5.,6.,0.,0.,1.;", 13, 0, {4, 5, 6}},
        {"106,1,3,0.,1.,2.,3.,4.,5.,6.;", 63, 0, {1, 2, 0}},
        {"106,1,4,0.,1.,2.,3.,4.,5.,6.,1.,2.;", 63, 0, {1, 2, 0}},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 106, cases[i].form, 0, 0, "00000000", cases[i].text);
        batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->point_count, cases[i].points);
        if (object->kind == BATTEN_OBJECT_POINTS)
            for (int k = 0; k < 3; k++)
                CHECK_BITS(object->points[3 + k], cases[i].last[k]);
        else
            check_point(object->curve, 1, cases[i].last[0], cases[i].last[1], cases[i].last[2]);
        batten_model_unref(model);
    }
}

TEST(Q5_copious_data_for_drawings_or_of_an_unknown_kind_are_left_out)
{
    static const struct {
        const char *text;
        int form;
        const char *words;
    } cases[] = {{"106,1,2,0.,1.,2.,3.,4.;", 31, "its form 31 is not read"},
                 {"106,4,2,0.,1.,2.,3.,4.;", 2, "its points are of kind 4, not 1, 2 or 3"},
                 {"106,2,3,1.,2.,3.,4.,5.,6.;", 2, "9 parameters, need 12"},
                 {"106,2,0;", 2, "it has 0 points"},
                 {"106,2,1,1.,2.,3.;", 12, "a row of 1 point is not a curve"}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 106, cases[i].form, 0, 0, "00000000", cases[i].text);
        iges_check_left_out(&file, cases[i].words);
    }
}

TEST(a_point_is_moved_by_its_matrix)
{
    iges_text file = iges_begin();
    iges_add(&file, 116, 0, 3, 0, "00000000", "116,1.,2.,3.;");
    iges_add(&file, 124, 0, 0, 0, "00000000", "124,0.,-1.,0.,5.,1.,0.,0.,0.,0.,0.,1.,0.;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    const batten_object *object = batten_model_object(model, 0);
    CHECK_INT(object->kind, BATTEN_OBJECT_POINTS);
    CHECK_TEXT(object->name, "points D1");
    CHECK_BITS(object->points[0], 3.0);
    CHECK_BITS(object->points[1], 1.0);
    CHECK_BITS(object->points[2], 3.0);
    batten_model_unref(model);
}

TEST(a_parametric_spline_is_its_cubics)
{
    /* x = s, y = s^2 on 0..2, then x = 2 + s, y = 4 + 4 s + s^2 to 3; in the plane z = 5. */
    iges_text file = iges_begin();
    iges_add(&file, 112, 0, 0, 0, "00000000",
             "112,3,1,3,2,0.,2.,3.,0.,1.,0.,0.,0.,0.,1.,0.,5.,0.,0.,0.,"
             "2.,1.,0.,0.,4.,4.,1.,0.,5.,0.,0.,0.,3.,1.,0.,0.,9.,6.,1.,0.,5.,0.,0.,0.;");
    batten_model *model = read_curve(&file, "");
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    for (int i = 0; i <= 12; i++)
        check_point(curve, i / 12.0, i / 4.0, i * i / 16.0, 5);
    batten_model_unref(model);
    static const struct {
        const char *text, *words;
    } bad[] = {{"112,3,1,3,0,0.,2.;", "it has 0 segments"},
               {"112,3,1,3,2,0.,2.,3.,0.,1.;", "10 parameters, need 32"}};
    for (int i = 0; i < COUNT(bad); i++) {
        iges_text left = iges_begin();
        iges_add(&left, 112, 0, 0, 0, "00000000", bad[i].text);
        iges_check_left_out(&left, bad[i].words);
    }
}

TEST(an_offset_of_a_circle_against_the_clock_shrinks_along_z)
{
    static const double radii[] = {1.5, 2.5};
    for (int i = 0; i < COUNT(radii); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 100, 0, 0, 0, "00010000", "100,0.,0.,0.,2.,0.,-2.,0.;");
        iges_add(&file, 130, 0, 0, 0, "00000000",
                 i ? "130,1,1,,,,.5,,,,0.,0.,-1.,0.,3.1415926535897931;"
                   : "130,1,1,,,,.5,,,,0.,0.,1.,0.,3.1415926535897931;");
        batten_model *model = read_curve(&file, "");
        for (int k = 0; k <= 10; k++) {
            double p[3];
            point_at(batten_model_object(model, 0)->curve, k / 10.0, p);
            CHECK_NEAR(hypot(p[0], p[1]), radii[i], 1e-12);
        }
        batten_model_unref(model);
    }
    iges_text varying = iges_begin();
    iges_add(&varying, 110, 0, 0, 0, "00010000", "110,0.,0.,0.,2.,0.,-2.;");
    iges_add(&varying, 130, 0, 0, 0, "00000000", "130,1,3,1,1,2,.5,,,,0.,0.,1.,0.,1.;");
    iges_check_left_out(&varying, "its distance varies (flag 3)");
}

/* Open CASCADE draws the points 106 form 2 as the polyline that also stands there as form 12,
 * and gives a length, that of the two points, to a ray and an infinite line, which are left
 * out. */
TEST(curves_of_another_program_have_the_length_that_open_cascade_finds)
{
    batten_model *model = NULL;
    double sum = 2 * sqrt(5.0), length = 0;
    CHECK_STATUS(
        batten_read_file(test_data("iges/igesio_sample_curves.igs"), NULL, NULL, NULL, &model),
        BATTEN_PARTLY_READ);
    CHECK_MESSAGE("2 of 10 entities are left out");
    CHECK_INT(batten_model_count(model), 8);
    for (int i = 0; i < 8; i++)
        if (batten_model_object(model, i)->curve) {
            CHECK_OK(
                batten_curve_length(batten_model_object(model, i)->curve, 1e-8, NULL, &length));
            sum += length;
        }
    CHECK_INT(batten_model_object(model, 6)->point_count, 5);
    CHECK_NEAR(sum + length, 66.3084143, 1e-6);
    batten_model_unref(model);
}
