#include "support/test.h"
#include <batten/approximate.h>
#include <batten/arcs.h>
#include <batten/standard.h>

static batten_chain *exact(const batten_curve *curve)
{
    batten_chain *chain = NULL;
    CHECK_OK(batten_arcs_from_curve_exact(curve, &chain));
    return chain;
}

static double length_of(const batten_chain *chain)
{
    double length = 0;
    for (int i = 0; i < batten_chain_span_count(chain); i++)
        length += batten_chain_span(chain, i)->length;
    return length;
}

/* A map of the plane that keeps shapes: turned, moved far, scaled. */
static batten_curve *moved(batten_curve *curve, double scale, double angle, double x)
{
    const double c = scale * cos(angle), s = scale * sin(angle);
    const batten_affine map = {{{c, -s, 0}, {s, c, 0}, {0, 0, scale}}, {x, -2 * x, 0}};
    batten_curve *out = NULL;
    CHECK_OK(batten_curve_transform(curve, &map, &out));
    batten_curve_unref(curve);
    return out;
}

TEST(circles_of_all_forms_degrees_sizes_and_places_are_arcs_on_themselves)
{
    for (int form = 0; form < 3; form++)
        for (int k = 0; k < 12; k++) {
            const double radius = pow(10, k - 5), x = k % 2 ? 50 * radius : 0;
            batten_curve *curve = NULL, *raised = NULL, *fine = NULL;
            const double knots[3] = {0.1, 0.3, 0.77};
            CHECK_OK(batten_curve_circle(1, (batten_circle_form)form, &curve));
            CHECK_OK(batten_curve_elevate(curve, k % 4, &raised));
            CHECK_OK(batten_curve_refine(raised, 3, knots, &fine));
            fine = moved(fine, radius, k, x);
            batten_chain *chain = exact(fine);
            CHECK(chain != NULL);
            CHECK(batten_chain_is_closed(chain));
            CHECK_NEAR(length_of(chain) / radius, 2 * acos(-1), 1e-11);
            for (int i = 0; i <= 40; i++) {
                double at[2];
                CHECK_OK(
                    batten_chain_evaluate(chain, batten_chain_domain(chain).b * i / 40, 0, at));
                CHECK_NEAR(hypot(at[0] - x, at[1] + 2 * x) / radius, 1, 1e-11);
            }
            batten_chain_unref(chain);
            batten_curve_unref(curve);
            batten_curve_unref(raised);
            batten_curve_unref(fine);
        }
}

TEST(a_piece_that_turns_by_more_than_half_a_circle_is_two_arcs)
{
    const double angles[4] = {3.5, 4.7, 5.5, 6.1};
    for (int k = 0; k < 4; k++) {
        /* The square of a rational arc, as a complex number, has twice its angle and degree. */
        const double half = angles[k] / 4, w = cos(half), a[3] = {1, w, 1};
        const double x[3] = {1, w, cos(2 * half)}, y[3] = {0, sin(half), sin(2 * half)};
        const double knots[10] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, c[3] = {1, 2, 1};
        const double binomials[5] = {1, 4, 6, 4, 1};
        double points[5][2] = {{0}}, weights[5] = {0};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                const double share = c[i] * c[j] / binomials[i + j];
                points[i + j][0] += share * (x[i] * x[j] - y[i] * y[j]);
                points[i + j][1] += share * 2 * x[i] * y[j];
                weights[i + j] += share * a[i] * a[j];
            }
        for (int i = 0; i < 5; i++)
            for (int d = 0; d < 2; d++)
                points[i][d] /= weights[i];
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_create((batten_points){2, 5, points[0]}, 4, weights, knots, &curve));
        batten_chain *chain = exact(curve);
        CHECK(chain != NULL);
        CHECK_NEAR(length_of(chain), angles[k], 1e-10);
        batten_chain_unref(chain);
        batten_curve_unref(curve);
    }
}

TEST(lines_of_any_degree_are_lines_and_go_on_as_one)
{
    const double knots[10] = {0, 0, 0, 0, 1, 3, 7, 7, 7, 7};
    const double along[6] = {0, 0.1, 0.5, 2, 2, 5};
    double points[6][2];
    for (int i = 0; i < 6; i++) {
        points[i][0] = 1000 + 3 * along[i];
        points[i][1] = -4 * along[i];
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 6, points[0]}, 3, NULL, knots, &curve));
    batten_chain *chain = exact(curve);
    CHECK(chain != NULL);
    CHECK_INT(batten_chain_span_count(chain), 1);
    CHECK_NEAR(length_of(chain), 25, 1e-11);
    CHECK(batten_chain_span(chain, 0)->curvature[0] == 0);
    batten_chain_unref(chain);
    batten_curve_unref(curve);
    /* One that turns back is none. */
    points[2][0] = 1000 + 3 * 6;
    points[2][1] = -4 * 6;
    CHECK_OK(batten_curve_create((batten_points){2, 6, points[0]}, 3, NULL, knots, &curve));
    CHECK(exact(curve) == NULL);
    batten_curve_unref(curve);
}

TEST(curves_that_are_a_little_different_are_none)
{
    batten_curve *curve = NULL, *other = NULL;
    for (int k = 0; k < 2; k++) {
        double point[2];
        CHECK_OK(batten_curve_arc(10, 1.5, &curve));
        memcpy(point, batten_curve_points(curve) + 2, sizeof point);
        point[k] += 1e-9;
        CHECK_OK(batten_curve_with_point(curve, 1, point, &other));
        CHECK(exact(other) == NULL);
        batten_curve_unref(curve);
        batten_curve_unref(other);
    }
    CHECK_OK(batten_curve_ellipse(10, 10.00001, 0, 3, &curve));
    CHECK(exact(curve) == NULL);
    batten_curve_unref(curve);
    const double line[8] = {0, 0, 1, 0, 2, 1e-9, 3, 0};
    const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    CHECK_OK(batten_curve_create((batten_points){2, 4, line}, 3, NULL, knots, &curve));
    CHECK(exact(curve) == NULL);
    batten_curve_unref(curve);
    const double same[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    CHECK_OK(batten_curve_create((batten_points){2, 4, same}, 3, NULL, knots, &curve));
    CHECK(exact(curve) == NULL);
    batten_curve_unref(curve);
}

TEST(in_space_the_plane_is_that_of_the_curve)
{
    const batten_vec3 axes[3][2] = {
        {{0, 1, 0}, {1, 0, 0}}, {{1, 0, 0}, {0, -1, 0}}, {{1, 0, 0}, {0, 0, 1}}};
    for (int k = 0; k < 4; k++) {
        batten_frame plane = {{1, 2, 3}, axes[k % 3][0], axes[k % 3][1]}, found;
        if (k == 3)
            plane.z = (batten_vec3){0, 0.6, 0.8};
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_arc_in(&plane, 5, 0.5, 4, &curve));
        batten_chain *chain = exact(curve);
        CHECK((chain != NULL) == (k < 3));
        if (chain) {
            double at[3];
            CHECK(batten_chain_frame(chain, &found));
            CHECK_NEAR(found.z.z, plane.z.z, 0);
            CHECK_OK(batten_chain_evaluate(chain, 0.3, 0, at));
            CHECK_NEAR(at[k], k + 1, 0);
            const double off[3] = {at[0] - 1, at[1] - 2, at[2] - 3};
            CHECK_NEAR(hypot(hypot(off[0], off[1]), off[2]), 5, 1e-13);
        }
        batten_chain_unref(chain);
        batten_curve_unref(curve);
    }
}
