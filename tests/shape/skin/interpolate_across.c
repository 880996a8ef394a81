/* Smooth poles of skins: one tangent plane, and no crease that the sections have not. */
#include "shape/sections.h"

#include <batten/standard.h>

#include "numeric/vector.h"

static batten_curve *circle_at(double radius, double z)
{
    batten_curve *flat = NULL, *space = NULL, *moved = NULL;
    const batten_affine map = batten_affine_translation(0, 0, z);
    CHECK_OK(batten_curve_circle(radius, BATTEN_CIRCLE_SQUARE_9, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &space));
    CHECK_OK(batten_curve_transform(space, &map, &moved));
    batten_curve_unref(space);
    batten_curve_unref(flat);
    return moved;
}

TEST(a_smooth_pole_has_one_tangent_plane_and_no_knots_of_its_own)
{
    static const double knots[] = {0, 0, 1, 1}, still[6] = {0.1, 0, 2, 0.1, 0, 2};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_curve *low = circle_at(1, 0), *high = circle_at(0.8, 1), *tip = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, still}, 1, NULL, knots, &tip));
    const batten_curve *sections[] = {low, high, tip};
    options.smooth_poles = true;
    CHECK_OK(batten_surface_skin((batten_curve_row){3, sections}, &options, NULL, NULL, NULL,
                                 &surface));
    CHECK_INT(batten_surface_spans(surface, BATTEN_U, NULL), batten_curve_spans(low, NULL));
    for (int i = 0; i <= 20; i++) {
        double d[9];
        CHECK_OK(batten_surface_evaluate_side(
            surface, i / 20.0, 1, (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_LEFT}, 1, d));
        CHECK_NEAR(d[2], 2, 1e-14);
        CHECK(hypot(d[6], d[7]) > 0.1); /* it leaves the pole, */
        CHECK_NEAR(d[8], 0, 1e-12);     /* level with it */
    }
    batten_surface_unref(surface);
    batten_curve_unref(tip);
    batten_curve_unref(high);
    batten_curve_unref(low);
}

/* Radii and heights of circles, whose first and last are points. */
typedef struct {
    int count;
    double radii[5], heights[5], wide; /* stretched across by `wide` */
    double from_start, from_end;       /* tips beside the axis */
} pointed_body;

static void make_pointed_body(const pointed_body *body, batten_curve **sections)
{
    static const double knots[] = {0, 0, 1, 1};
    for (int k = 0; k < body->count; k++) {
        if (body->radii[k] == 0) {
            const double x = k == 0 ? body->from_start : body->from_end, z = body->heights[k];
            const double still[6] = {x, 0, z, x, 0, z};
            CHECK_OK(batten_curve_create((batten_points){3, 2, still}, 1, NULL, knots,
                                         &sections[k]));
            continue;
        }
        batten_curve *round = circle_at(body->radii[k], body->heights[k]);
        const batten_affine stretch = batten_affine_scaling(body->wide, 1, 1);
        CHECK_OK(batten_curve_transform(round, &stretch, &sections[k]));
        batten_curve_unref(round);
    }
}

/* The largest angle between the normals on both sides of u = 1/4, 1/2, 3/4 and the seam. */
static double largest_crease(const batten_surface *surface)
{
    double worst = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 1; j < 200; j++) {
            batten_vec3 normal[2];
            for (int side = 0; side < 2; side++) {
                double d[9];
                const double u = side == 0 && i == 0 ? 1 : i / 4.0;
                CHECK_OK(batten_surface_evaluate_side(
                    surface, u, j * j * j / 8e6,
                    (batten_sides){side == 0 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT,
                                   BATTEN_FROM_RIGHT},
                    1, d));
                normal[side] = bat_vec3_cross(bat_vec3_of(3, d + 3), bat_vec3_of(3, d + 6));
            }
            const double sine = bat_vec3_norm(bat_vec3_cross(normal[0], normal[1]));
            worst = fmax(worst, atan2(sine, bat_vec3_dot(normal[0], normal[1])));
        }
    return worst;
}

static const pointed_body smooth_bodies[] = {
    {3, {0, 0.8660254037844386, 1}, {-1, -0.5, 0}, 1, 0, 0},
    {5, {0, 0.8660254037844386, 1, 0.8660254037844386, 0}, {-1, -0.5, 0, 0.5, 1}, 1, 0, 0},
    {5, {0, 1, 1.2, 0.5, 0}, {0, 0.2, 1, 1.5, 1.6}, 2.5, 0.3, -0.2},
};

TEST(a_smooth_pole_of_rational_sections_has_no_crease)
{
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.smooth_poles = true;
    for (int i = 0; i < COUNT(smooth_bodies); i++) {
        batten_curve *sections[5] = {0};
        batten_surface *surface = NULL;
        batten_surface_skin_report report = {0};
        make_pointed_body(&smooth_bodies[i], sections);
        CHECK_OK(batten_surface_skin(
            (batten_curve_row){smooth_bodies[i].count, (const batten_curve *const *)sections},
            &options, NULL, NULL, &report, &surface));
        CHECK_NEAR(report.crease, 0, 1e-9);
        CHECK_NEAR(largest_crease(surface), 0, 1e-9);
        batten_surface_unref(surface);
        unref_all(smooth_bodies[i].count, sections);
    }
}

TEST(smooth_poles_need_an_odd_degree_and_a_plane)
{
    static const double knots[] = {0, 0, 1, 1}, still[6] = {0, 0, 2, 0, 0, 2};
    const double a[] = {-1, 0, 1}, b[] = {1, 0, 1}, c[] = {-1, 0, 0}, d[] = {1, 0, 0};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_curve *low = circle_at(1, 0), *high = circle_at(0.8, 1), *tip = NULL;
    batten_curve *lines[2] = {NULL, NULL};
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, still}, 1, NULL, knots, &tip));
    CHECK_OK(batten_curve_line(3, c, d, &lines[0]));
    CHECK_OK(batten_curve_line(3, a, b, &lines[1]));
    const batten_curve *round[] = {low, high, tip}, *straight[] = {lines[0], lines[1], tip};
    options.smooth_poles = true;
    options.degree = 2;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){3, round}, &options, NULL, NULL, NULL, &surface),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a smooth pole needs an odd degree, and it is 2");
    options.degree = 3;
    CHECK_STATUS(batten_surface_skin((batten_curve_row){3, straight}, &options, NULL, NULL,
                                     NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("section 2, next to the smooth pole, is straight and has no plane");
    batten_curve_unref(lines[0]);
    batten_curve_unref(lines[1]);
    batten_curve_unref(low);
    batten_curve_unref(high);
    batten_curve_unref(tip);
}
