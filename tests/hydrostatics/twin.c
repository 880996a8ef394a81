/* Catamarans of boxes, by their closed forms. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

#include <batten/measure.h>
#include <batten/standard.h>

static const double DEGREE = 3.14159265358979323846 / 180;

/* Of the box_hull: 4 long, 2 wide, 2 deep. */
static batten_status make_twin(double spacing, batten_hull **out)
{
    static const double section[][2] = {{0, 0}, {1, 0}, {1, 2}};
    batten_hull *one = NULL;
    batten_surface *half = half_prism(0, 4, 3, section);
    const batten_surface *const surfaces[] = {half};
    batten_status status = batten_hull_create(1, surfaces, NULL, &one);
    batten_surface_unref(half);
    if (status != BATTEN_OK || spacing == 0) {
        *out = status == BATTEN_OK ? one : *out;
        return status;
    }
    status = batten_hull_twin(one, spacing, out);
    batten_hull_free(one);
    return status;
}

TEST(a_catamaran_of_boxes_has_two_volumes_and_the_moments_of_its_spacing)
{
    const double t = 0.9, s = 7, moment = 2 * (4 * 8 / 12. + 8 * s * s / 4);
    const batten_flotation at = {t, 0, 0};
    batten_hydrostatics v;
    batten_interval along, across;
    batten_hull *hull = NULL;
    int count = 0;
    double area = 0;
    CHECK_OK(make_twin(s, &hull));
    CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-12, NULL, &v));
    CHECK_NEAR(v.volume, 16 * t, 1e-11);
    CHECK_NEAR(v.buoyancy.y, 0, 1e-12);
    CHECK_NEAR(v.buoyancy.z, t / 2, 1e-12);
    CHECK_NEAR(v.waterplane, 16, 1e-11);
    CHECK_NEAR(v.across, moment, 1e-9 * moment);
    CHECK_NEAR(v.along, 2 * 2 * 64 / 12., 1e-10);
    CHECK_NEAR(v.wetted, 2 * 4 * (2 + 2 * t), 1e-10);
    CHECK_OK(batten_hull_waterline(hull, &at, 1e-9, &along, &across));
    CHECK_NEAR(across.a, -s / 2 - 1, 1e-8);
    CHECK_NEAR(across.b, s / 2 + 1, 1e-8);
    CHECK_OK(batten_hull_section_area(hull, &at, 1, 1e-9, NULL, &area));
    CHECK_NEAR(area, 4 * t, 1e-7);
    (void)batten_hull_lids(hull, &count);
    CHECK(count == 3); /* both ends and the deck */
    CHECK_NEAR(batten_hull_box(hull).low.y, -s / 2 - 1, 1e-12);
    batten_hull_free(hull);
}

/* Both hulls are without flare until a bottom leaves the water or a deck meets it. */
TEST(a_catamaran_of_boxes_rights_itself_by_the_wall_sided_formula)
{
    const double t = 0.9, s = 3, kg = 1.7;
    const double bm = 2 * (4 * 8 / 12. + 8 * s * s / 4) / (16 * t), gm = t / 2 + bm - kg;
    batten_hull *hull = NULL;
    CHECK_OK(make_twin(s, &hull));
    for (int degrees = 0; degrees <= 19; degrees++) { /* the keel rises 2.5 tan phi */
        const double phi = degrees * DEGREE, tangent = tan(phi);
        const batten_loading loading = {16 * t, {2, 0, kg}, true, false};
        const batten_flotation start = {0.5, 0.01, phi};
        batten_balance b;
        CHECK_OK(batten_hull_balance(hull, &loading, &start, 1e-12, NULL, &b));
        CHECK_NEAR(b.heeling, sin(phi) * (gm + bm / 2 * tangent * tangent), 1e-10);
    }
    batten_hull_free(hull);
}

TEST(hulls_of_a_catamaran_do_not_overlap)
{
    batten_hull *hull = NULL;
    CHECK_STATUS(make_twin(1.9, &hull), BATTEN_BAD_ARGUMENT);
    CHECK_CONTAINS(batten_message(), "overlap");
    CHECK_STATUS(make_twin(-1, &hull), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(make_twin(NAN, &hull), BATTEN_BAD_ARGUMENT);
    CHECK(!hull);
}

/* The edge of the deck is 2 above the keel, at y = -1 and 1, or of a catamaran farther out. */
TEST(the_edge_of_a_deck_stands_above_the_water_as_the_plane_says)
{
    static const double spacings[] = {0, 5};
    for (int i = 0; i < COUNT(spacings); i++)
        for (int k = 0; k < 9; k++) {
            const double trim = (k / 3 - 1) * 4 * DEGREE, heel = (k % 3 - 1) * 11 * DEGREE;
            const double side = spacings[i] / 2 + 1, sign = heel > 0 ? -1 : 1;
            const batten_flotation at = {0.9, trim, heel};
            /* The plane through (0, 0, 0.9), down to starboard and towards lower x. */
            const double x = trim < 0 ? 4 : 0, y = sign * side;
            const double expected =
                sin(trim) * x + cos(trim) * sin(heel) * y + cos(trim) * cos(heel) * (2 - 0.9);
            batten_hull *hull = NULL;
            batten_vec3 place;
            double freeboard = 0;
            CHECK_OK(make_twin(spacings[i], &hull));
            CHECK_OK(batten_hull_freeboard(hull, &at, &freeboard, &place));
            CHECK_NEAR(freeboard, expected, 1e-12);
            CHECK_NEAR(place.z, 2, 1e-12);
            batten_hull_free(hull);
        }
}

/* A curved sheer: the lowest place of z = 2 - x (4 - x) / 10 is between the ends. */
TEST(the_lowest_place_of_a_sheer_is_found_between_its_ends)
{
    static const double knots[] = {0, 0, 0, 1, 1, 1}, knots_v[] = {0, 0, 1, 1};
    const double points[3][2][3] = {
        {{0, 0, 0}, {0, 1, 2}}, {{2, 0, 0}, {2, 1, 1.2}}, {{4, 0, 0}, {4, 1, 2}}};
    const batten_axis u = {2, 3, knots, false}, v = {1, 2, knots_v, false};
    const double slope = 0.05, lowest = 2 - 5 * slope; /* where x / 5 - 2/5 + slope is 0 */
    const batten_flotation at = {0.5, atan(slope), 0};
    batten_surface *half = NULL;
    batten_vec3 place;
    double freeboard = 0;
    CHECK_OK(batten_surface_create(3, &u, &v, &points[0][0][0], NULL, &half));
    batten_hull *hull = hull_of(half);
    CHECK_OK(batten_hull_freeboard(hull, &at, &freeboard, &place));
    CHECK_NEAR(place.x, lowest, 1e-5); /* the height changes with its square */
    CHECK_NEAR(freeboard,
               cos(at.trim) * (2 - lowest * (4 - lowest) / 10 - 0.5 + slope * lowest), 1e-11);
    batten_hull_free(hull);
}

static batten_status make_ball(batten_hull **out)
{
    const batten_frame world = batten_frame_world();
    batten_surface *ball = NULL;
    batten_hull_options options = batten_hull_defaults();
    options.whole = true;
    batten_status status = batten_surface_sphere(&world, 1, &ball);
    if (status != BATTEN_OK)
        return status;
    status = batten_hull_create(1, (const batten_surface *const[]){ball}, &options, out);
    batten_surface_unref(ball);
    return status;
}

TEST(a_hull_without_an_edge_of_a_deck_has_no_freeboard)
{
    double freeboard = 7;
    const batten_flotation at = {0, 0, 0};
    batten_hull *hull = NULL;
    CHECK_OK(make_ball(&hull));
    CHECK_STATUS(batten_hull_freeboard(hull, &at, &freeboard, NULL), BATTEN_NOT_FOUND);
    CHECK(freeboard == 7);
    batten_hull_free(hull);
}
