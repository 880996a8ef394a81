/* Edges by shares of their length, and the warp of a ruling between two. */
#include "shape/plate/developable_parts.h"

#include "shape/plate/plates.h"

static void make_edge(const batten_curve *curve, bat_plate_edge *out)
{
    CHECK_OK(bat_plate_edge_make(curve, "first", out));
}

/* The circle with another parameter: what counts is its length. */
TEST(a_share_of_an_edge_is_a_share_of_its_length)
{
    batten_curve *curves[] = {arc(2, 0.5, 2, 3), reparametrised(arc(2, 0.5, 2, 3))};
    for (int k = 0; k < COUNT(curves); k++) {
        bat_plate_edge edge;
        make_edge(curves[k], &edge);
        CHECK_NEAR(edge.length, 3, 1e-10);
        const batten_interval domain = batten_curve_domain(curves[k]);
        CHECK(edge.u[0] == domain.a && edge.u[BAT_EDGE_STEPS] == domain.b);
        for (int i = 0; i <= 57; i++) {
            bat_edge_place at;
            const double x = i / 57.0, angle = 0.5 + 1.5 * x;
            CHECK_OK(bat_plate_edge_at(&edge, x, &at));
            CHECK(at.u >= domain.a && at.u <= domain.b);
            CHECK_NEAR(at.P.x, 2 * cos(angle), 1e-8);
            CHECK_NEAR(at.P.y, 2 * sin(angle), 1e-8);
            CHECK_NEAR(at.P.z, 3, 1e-15);
            CHECK_NEAR(at.T.x, -sin(angle), 1e-8);
            CHECK_NEAR(at.T.y, cos(angle), 1e-8);
        }
        batten_curve_unref(curves[k]);
    }
}

TEST(edges_with_corners_or_standstills_are_refused_with_their_place)
{
    static const double bent[] = {0, 0, 0, 1, 0, 0, 2, 1, 0},
                        straight[] = {0, 0, 0, 1, 0, 0, 3, 0, 0};
    static const double knots[] = {0, 0, 0.25, 1, 1}, cubic[] = {0, 0, 0, 0, 1, 1, 1, 1};
    static const double still[] = {0, 0, 0, 0, 0, 0, 1, 1, 0, 2, 1, 0};
    bat_plate_edge edge;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, bent}, 1, NULL, knots, &curve));
    CHECK_STATUS(bat_plate_edge_make(curve, "second", &edge), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE(
        "the second edge has a corner at 0.25; split it there and make a plate for each part");
    batten_curve_unref(curve);
    curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, straight}, 1, NULL, knots, &curve));
    CHECK_OK(bat_plate_edge_make(curve, "second", &edge)); /* a step of speed is no corner */
    CHECK_NEAR(edge.length, 3, 1e-12);
    batten_curve_unref(curve);
    curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 4, still}, 3, NULL, cubic, &curve));
    CHECK_STATUS(bat_plate_edge_make(curve, "first", &edge), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the first edge has no tangent at 0");
    batten_curve_unref(curve);
}

/* Rulings along z, with tangents at these angles about it: the warp is their difference. */
TEST(the_warp_of_a_ruling_is_the_angle_between_its_tangent_planes_with_a_sign)
{
    static const double angles[][2] = {{0, 0},   {0.3, 0.3}, {0, 0.4},
                                       {0.4, 0}, {-1, 1.5},  {2, -1}};
    for (int i = 0; i < COUNT(angles); i++)
        for (int turned = 0; turned < 2; turned++) {
            bat_edge_place a = {.P = {1, 2, 3}}, b = {.P = {1, 2, 5}};
            double sine = 7, cosine = 7;
            const double s = angles[i][0], t = angles[i][1];
            /* A part along the ruling makes no difference. */
            a.T = (batten_vec3){0.8 * cos(s), 0.8 * sin(s), 0.6};
            b.T = (batten_vec3){0.6 * cos(t), 0.6 * sin(t), -0.8};
            CHECK(bat_warp_of(turned ? &b : &a, turned ? &a : &b, 1, &sine, &cosine));
            CHECK_NEAR(sine, sin(t - s), 1e-15); /* seen from the other end it turns alike */
            CHECK_NEAR(cosine, cos(t - s), 1e-15);
        }
}

TEST(short_rulings_and_those_along_a_tangent_have_no_warp)
{
    bat_edge_place a = {.P = {0, 0, 0}, .T = {1, 0, 0}}, b = {.P = {0, 0, 2}, .T = {0, 1, 0}};
    double sine = 7, cosine = 7;
    CHECK(!bat_warp_of(&a, &b, 2, &sine, &cosine));
    CHECK(bat_warp_of(&a, &b, 1.999, &sine, &cosine));
    for (int e = 0; e < 2; e++) {
        bat_edge_place along[2] = {a, b};
        along[e].T = (batten_vec3){0, 0, 1};
        CHECK(!bat_warp_of(&along[0], &along[1], 1, &sine, &cosine));
    }
}

/* Coaxial arcs of lengths 1.5 and 3: equal shares have no warp. */
TEST(the_warp_of_a_pair_of_shares_is_that_of_their_points)
{
    bat_plate plate = {.size = 3};
    batten_curve *curves[] = {arc(1, 0, 1.5, 0), arc(2, 0, 1.5, 1)};
    for (int e = 0; e < 2; e++)
        make_edge(curves[e], &plate.edge[e]);
    for (int i = 0; i <= 4; i++) {
        bool has = false;
        double sine = 7, cosine = 7;
        CHECK_OK(bat_plate_warp(&plate, (bat_pair){i / 4.0, i / 4.0}, &has, &sine, &cosine));
        CHECK(has);
        CHECK_NEAR(sine, 0, 1e-8);
        CHECK_NEAR(cosine, 1, 1e-12);
        bat_edge_place a, b;
        double s, c;
        CHECK_OK(bat_plate_warp(&plate, (bat_pair){i / 4.0, 0.25}, &has, &sine, &cosine));
        CHECK_OK(bat_plate_edge_at(&plate.edge[0], i / 4.0, &a));
        CHECK_OK(bat_plate_edge_at(&plate.edge[1], 0.25, &b));
        CHECK(bat_warp_of(&a, &b, 1e-9, &s, &c) && s == sine && c == cosine);
    }
    drop(curves[0], curves[1]);
}
