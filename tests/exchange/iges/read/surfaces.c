/* The surfaces of IGES against what their formulas say. */
#include "exchange/iges/read/surfaces.h"

#include "exchange/iges/text.h"

/* The only object of a file, a surface. */
static batten_model *read_surface(iges_text *file, const char *note)
{
    batten_model *model = read_noting(iges_end(file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, note);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_SURFACE);
    return model;
}

static void point_at(const batten_model *model, double u, double v, double p[3])
{
    const batten_surface *surface = batten_model_object(model, 0)->surface;
    const batten_interval a = batten_surface_domain(surface, BATTEN_U);
    const batten_interval b = batten_surface_domain(surface, BATTEN_V);
    CHECK_OK(
        batten_surface_evaluate(surface, a.a + u * (a.b - a.a), b.a + v * (b.b - b.a), 0, p));
}

static void check_point(const batten_model *model, double u, double v, double x, double y,
                        double z)
{
    double p[3];
    point_at(model, u, v, p);
    CHECK_NEAR(p[0], x, 1e-9);
    CHECK_NEAR(p[1], y, 1e-9);
    CHECK_NEAR(p[2], z, 1e-9);
}

TEST(a_surface_of_revolution_turns_its_generatrix_about_its_axis)
{
    /* A cylinder of radius 2 from z = 0 to 5, from 90 degrees to 180. */
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00010000", "110,0.,0.,0.,0.,0.,1.;");
    iges_add(&file, 110, 0, 0, 0, "00010000", "110,2.,0.,0.,2.,0.,5.;");
    iges_add(&file, 120, 0, 0, 0, "00000000", "120,1,3,1.5707963267948966,3.1415926535897931;");
    batten_model *model = read_surface(&file, "");
    check_point(model, 0, 0, 0, 2, 0);
    check_point(model, 1, 0, 0, 2, 5);
    check_point(model, 0, 1, -2, 0, 0);
    for (int i = 0; i <= 10; i++) {
        double p[3];
        point_at(model, i / 10.0, 1 - i / 10.0, p);
        CHECK_NEAR(hypot(p[0], p[1]), 2, 1e-12);
    }
    batten_model_unref(model);
}

TEST(surfaces_of_revolution_without_axis_or_angle_are_left_out)
{
    static const struct {
        const char *axis, *text, *words;
    } cases[] = {
        {"110,0.,0.,0.,0.,0.,0.;", "120,1,3,0.,1.;", "its axis D1 is a point"},
        {"110,0.,0.,0.,0.,0.,1.;", "120,1,3,1.,1.;", "it turns from 1 to 1 radians"},
        {"110,0.,0.,0.,0.,0.,1.;", "120,1,3,0.,7.;", "it turns from 0 to 7 radians"},
        {"110,0.,0.,0.,0.,0.,1.;", "120,1,5,0.,1.;", "D5 as a curve, which is a 120 surface"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, "00010000", cases[i].axis);
        iges_add(&file, 110, 0, 0, 0, "00010000", "110,2.,0.,0.,2.,0.,5.;");
        iges_add(&file, 120, 0, 0, 0, "00000000", cases[i].text);
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        iges_check_partly(&file, cases[i].words);
    }
}

TEST(a_tabulated_cylinder_goes_from_the_start_of_its_directrix_to_a_point)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00010000", "110,1.,0.,0.,3.,1.,0.;");
    iges_add(&file, 122, 0, 0, 0, "00000000", "122,1,1.,2.,7.;");
    batten_model *model = read_surface(&file, "");
    check_point(model, 0, 0, 1, 0, 0);
    check_point(model, 1, 0, 3, 1, 0);
    check_point(model, 0, 1, 1, 2, 7);
    check_point(model, 1, 1, 3, 3, 7);
    batten_model_unref(model);
}

TEST(a_ruled_surface_pairs_equal_parameters_or_equal_lengths)
{
    for (int form = 0; form < 2; form++)
        for (int turned = 0; turned < 2; turned++) {
            iges_text file = iges_begin();
            iges_add(&file, 110, 0, 0, 0, "00010000", "110,0.,0.,0.,4.,0.,0.;");
            /* A polyline whose second half, by its parameter, is three times as long. */
            iges_add(&file, 106, 12, 0, 0, "00010000", "106,2,3,0.,1.,0.,1.,1.,0.,4.,1.,0.;");
            iges_add(&file, 118, form, 0, 0, "00000000",
                     turned ? "118,1,3,1,0;" : "118,1,3,0,0;");
            batten_model *model = read_surface(&file, "");
            check_point(model, 0.5, 0, 2, 0, 0);
            check_point(model, turned ? 1 : 0, 1, 0, 1, 0);
            if (form == 1)
                check_point(model, 0.5, 1, 1, 1, 0);
            batten_model_unref(model);
        }
}

TEST(a_parametric_spline_surface_is_its_bicubics)
{
    /* z = s t on [0, 2] x [0, 3]: one patch, then the dummy of the row, and no last row. */
    iges_text file = iges_begin();
    char text[1024] = "114,3,1,1,1,0.,2.,0.,3.,";
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 16; i++)
            strcat(text, (c == 0 && i == 1) || (c == 1 && i == 4) || (c == 2 && i == 5) ? "1."
                                                                                        : "0."),
                strcat(text, c == 2 && i == 15 ? ";" : ",");
    iges_add(&file, 114, 0, 0, 0, "00000000", text);
    batten_model *model = read_surface(&file, "");
    for (int i = 0; i <= 4; i++)
        for (int j = 0; j <= 4; j++)
            check_point(model, i / 4.0, j / 4.0, i / 2.0, 0.75 * j, i / 2.0 * 0.75 * j);
    batten_model_unref(model);
    iges_text bad = iges_begin();
    iges_add(&bad, 114, 0, 0, 0, "00000000", "114,3,1,1,1,0.,2.,0.,3.,0.;");
    iges_check_left_out(&bad, "10 parameters, need 57");
}

TEST(an_offset_surface_goes_to_the_side_that_its_direction_shows)
{
    for (int side = 0; side < 2; side++) {
        iges_text file = iges_begin();
        iges_add(&file, 128, 0, 0, 0, "00010000", IGES_SURFACE);
        iges_add(&file, 140, 0, 0, 0, "00000000", side ? "140,,,1.,.5,1;" : "140,,,-1.,.5,1;");
        batten_model *model = read_surface(&file, "");
        double p[3];
        point_at(model, 0.5, 0.5, p);
        CHECK(side ? p[2] > 0.5 : p[2] < 0.5);
        batten_model_unref(model);
    }
    iges_text ring = iges_begin();
    iges_add(&ring, 140, 0, 0, 0, "00000000", "140,,,1.,.5,1;");
    iges_check_left_out(&ring, "entity D1 is a part of itself");
}

TEST(a_full_turn_closes)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00010000", "110,1.,1.,0.,1.,1.,4.;");
    iges_add(&file, 100, 0, 5, 0, "00010000", "100,0.,3.,0.,4.,0.,2.,0.;");
    iges_add(&file, 124, 0, 0, 0, "00000000", "124,1.,,,1.,,,-1.,1.,,1.,,2.;");
    iges_add(&file, 120, 0, 0, 0, "00000000", "120,1,3,0.,6.283185307;");
    batten_model *model = read_surface(&file, "");
    for (int i = 0; i <= 20; i++) {
        double p[3], q[3];
        point_at(model, i / 20.0, 0, p);
        point_at(model, i / 20.0, 1, q);
        CHECK_NEAR(hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]), 0, 1e-12);
        CHECK_NEAR(hypot(hypot(p[0] - 1, p[1] - 1) - 3, p[2] - 2), 1, 1e-12);
    }
    batten_model_unref(model);
}

/* Of a patch folded onto itself the normal jumps, and no number of points is enough. */
TEST(S5_an_offset_that_needs_too_many_points_is_left_out_soon)
{
    iges_text file = iges_begin();
    iges_add(&file, 128, 0, 0, 0, "00010000",
             "128,1,1,1,1,0,0,0,0,0,0.,0.,1.,1.,0.,0.,1.,1.,2.,1.,1.,1.,0.,0.,0.,0.,2.,1.,0.,1."
             ",3.,0.,2.,0.,0.,1.,0.,1.;");
    iges_add(&file, 140, 0, 0, 0, "00000000", "140,-1.,0.,0.,.5,1;");
    iges_check_left_out(&file, "control points come to");
}
