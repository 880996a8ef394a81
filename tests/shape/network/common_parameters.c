/* Common parameters of the curves of a network. */
#include "shape/network/gordon.h"

#include "support/test.h"

enum { PROFILES = 2, GUIDES = 3 };

typedef struct {
    bat_network net;
    batten_surface_gordon_options options;
    bat_network_curve profiles[PROFILES], guides[GUIDES];
    double at[PROFILES + GUIDES][3];
} bench;

/* A line from (x, y) to (X, Y). */
static batten_curve *line(double x, double y, double X, double Y)
{
    static const double knots[] = {0, 0, 1, 1};
    const double points[] = {x, y, 0, X, Y, 0};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &curve));
    return curve;
}

/* Profiles y = 0 and y = 1 over 0 .. 1; guides that miss their nodes by 0.01 at the middle. */
static void begin_bench(bench *b)
{
    static const double at[PROFILES + GUIDES][3] = {
        {0, 0.4, 1}, {0, 0.6, 1}, {0, 1}, {0, 1}, {0, 1}};
    *b = (bench){.options = batten_surface_gordon_defaults()};
    memcpy(b->at, at, sizeof at);
    b->net.options = &b->options;
    b->net.scale = b->net.size = 1;
    b->net.tolerance = 1e-3;
    b->net.family[0] = (bat_network_family){.count = PROFILES, .curves = b->profiles};
    b->net.family[1] = (bat_network_family){.count = GUIDES, .curves = b->guides};
    for (int k = 0; k < PROFILES; k++)
        b->profiles[k] =
            (bat_network_curve){.index = k, .curve = line(0, k, 1, k), .at = b->at[k]};
    b->guides[0] = (bat_network_curve){.curve = line(0, 0, 0, 1), .at = b->at[2]};
    b->guides[1] = (bat_network_curve){.curve = line(0.42, 0, 0.62, 1), .at = b->at[3]};
    b->guides[2] = (bat_network_curve){.curve = line(1, 0, 1, 1), .at = b->at[4]};
}

static void end_bench(bench *b)
{
    for (int family = 0; family < 2; family++) {
        bat_network_family *f = &b->net.family[family];
        for (int k = 0; k < f->count; k++) {
            batten_curve_unref(f->curves[k].curve);
            batten_curve_unref(f->curves[k].map);
        }
        bat_release(f->parameters);
    }
    bat_release(b->net.nodes);
}

TEST(nodes_stand_at_their_mean_parameters_and_curves_are_mapped_to_their_own)
{
    bench b;
    begin_bench(&b);
    const batten_status status = bat_network_parametrize(&b.net);
    if (status != BATTEN_OUT_OF_MEMORY) {
        CHECK_OK(status);
        static const double mean[] = {0, 0.5, 1};
        for (int i = 0; i < GUIDES; i++)
            CHECK_NEAR(b.net.family[0].parameters[i], mean[i], 1e-15);
        CHECK(b.net.family[1].parameters[0] == 0 && b.net.family[1].parameters[1] == 1);
        CHECK_NEAR(b.net.report.spread, 0.1, 1e-15);
        for (int k = 0; k < PROFILES; k++) {
            double before = -1, u;
            for (int i = 0; i < GUIDES; i++) {
                CHECK_OK(batten_curve_evaluate(b.profiles[k].map, mean[i], 0, &u));
                CHECK_NEAR(u, b.at[k][i], 1e-15);
            }
            for (int i = 0; i <= 50; i++, before = u) {
                CHECK_OK(batten_curve_evaluate(b.profiles[k].map, i / 50.0, 0, &u));
                CHECK(u > before);
            }
        }
        for (int i = 0; i < GUIDES; i++)
            CHECK(!b.guides[i].map);
    }
    end_bench(&b);
}

TEST(nodes_are_midway_between_the_curves_and_at_points_on_them)
{
    static const double x[2][GUIDES] = {{0, 0.41, 1}, {0, 0.61, 1}};
    for (int point = 0; point < 2; point++) {
        bench b;
        begin_bench(&b);
        if (point) {
            batten_curve_unref(b.profiles[1].curve);
            b.profiles[1].curve = NULL;
            b.profiles[1].curve = line(7, 1, 7, 1);
            b.profiles[1].point = true;
        }
        const batten_status status = bat_network_parametrize(&b.net);
        if (status != BATTEN_OUT_OF_MEMORY) {
            CHECK_OK(status);
            for (int j = 0; j < PROFILES; j++)
                for (int i = 0; i < GUIDES; i++) {
                    const double *node = b.net.nodes + 3 * (j * GUIDES + i);
                    CHECK_NEAR(node[0], point && j ? 7 : x[j][i], 1e-15);
                    CHECK_NEAR(node[1], j, 1e-15);
                    CHECK(node[2] == 0);
                }
            /* A point says nothing of the parameters and has those of the others. */
            for (int i = 0; i < GUIDES && point; i++) {
                CHECK(b.net.family[0].parameters[i] == b.at[0][i]);
                CHECK(b.at[1][i] == b.at[0][i]);
            }
            CHECK(!point || b.net.report.spread == 0);
        }
        end_bench(&b);
    }
}

/* A corner at 0.4002: a node beside it stands on it where it is nearer than a sixteenth of the tolerance or a
 * hundred-thousandth of the size. */
TEST(a_node_beside_a_corner_is_the_corner)
{
    static const double points[] = {0, 0, 0, 0.4002, 0, 0, 1, 0.1, 0},
                        knots[] = {0, 0, 0.4002, 1, 1};
    static const struct {
        double tolerance, size, at;
    } rows[] = {{4e-3, 100, 0.4002}, {3e-3, 100, 0.4}, {4e-3, 10, 0.4}};
    for (int i = 0; i < COUNT(rows); i++) {
        bench b;
        begin_bench(&b);
        batten_curve_unref(b.profiles[0].curve);
        b.profiles[0].curve = NULL;
        CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 1, NULL, knots,
                                     &b.profiles[0].curve));
        b.net.tolerance = rows[i].tolerance;
        b.net.size = rows[i].size;
        const batten_status status = bat_network_parametrize(&b.net);
        if (status != BATTEN_OUT_OF_MEMORY) {
            CHECK_OK(status);
            CHECK(b.at[0][1] == rows[i].at);
        }
        end_bench(&b);
    }
}
