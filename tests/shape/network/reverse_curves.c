/* A curve of a network is cut, reversed and begun where the others begin. */
#include "shape/network/gordon.h"

#include "support/test.h"

typedef struct {
    bat_network net;
    batten_surface_gordon_options options;
    bat_network_curve curve;
} bench;

/* A line of length 4 along x, or a square of side 4 about which the parameter goes evenly. */
static void begin_bench(bench *b, int family, bool closed)
{
    static const double line[] = {0, 0, 0, 4, 0, 0}, ends[] = {0, 0, 1, 1};
    static const double square[] = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, 0, 0, 0};
    static const double corners[] = {0, 0, 0.25, 0.5, 0.75, 1, 1};
    *b = (bench){.options = batten_surface_gordon_defaults(),
                 .curve = {.index = 2, .closed = closed}};
    b->net.options = &b->options;
    b->net.scale = 0.5; /* lengths of the caller are twice as large */
    b->net.gap = 0.25;
    b->net.family[0].what = "profile";
    b->net.family[1].what = "guide";
    b->net.family[family].closed = closed;
    CHECK_OK(batten_curve_create((batten_points){3, closed ? 5 : 2, closed ? square : line}, 1,
                                 NULL, closed ? corners : ends, &b->curve.curve));
}

static void end_bench(bench *b)
{
    bat_release(b->curve.at);
    b->curve.at = NULL;
    batten_curve_unref(b->curve.curve);
}

/* One try; a failure leaves no parameters behind. */
static batten_status turn(bench *b, int family, const double *ranked, bool reversed)
{
    const batten_status status =
        bat_network_turn(&b->net, family, &b->curve, 3, ranked, reversed);
    if (status != BATTEN_OK) {
        bat_release(b->curve.at);
        b->curve.at = NULL;
    }
    return status;
}

static const struct {
    bool closed, reversed;
    double ranked[3], at[4], start[2], end[2], cut;
    int cut_count;
} rows[] = {
    {false, false, {0, 0.5, 1}, {0, 0.5, 1}, {0, 0}, {4, 0}, 0, 0},
    {false, false, {0.25, 0.5, 1}, {0, 1.0 / 3, 1}, {1, 0}, {4, 0}, 2, 1},
    {false, false, {0.25, 0.5, 0.875}, {0, 0.4, 1}, {1, 0}, {3.5, 0}, 2, 1},
    {false, false, {0.125, 0.25, 0.75}, {0, 0.2, 1}, {0.5, 0}, {3, 0}, 2, 1},
    {false, true, {1, 0.75, 0}, {0, 0.25, 1}, {4, 0}, {0, 0}, 0, 0},
    {false, true, {0.875, 0.5, 0.25}, {0, 0.6, 1}, {3.5, 0}, {1, 0}, 2, 1},
    {true, false, {0, 0.5, 0.75}, {0, 0.5, 0.75, 1}, {0, 0}, {0, 0}, 0, 0},
    {true, false, {0.25, 0.5, 0.75}, {0, 0.25, 0.5, 1}, {4, 0}, {4, 0}, 0, 0},
    {true, false, {0.75, 0, 0.25}, {0, 0.25, 0.5, 1}, {0, 4}, {0, 4}, 0, 0},
    {true, true, {0.75, 0.5, 0.25}, {0, 0.25, 0.5, 1}, {0, 4}, {0, 4}, 0, 0},
    {true, true, {0, 0.75, 0.5}, {0, 0.25, 0.5, 1}, {0, 0}, {0, 0}, 0, 0},
};

TEST(a_curve_runs_from_its_first_node_to_its_last_in_the_direction_of_the_others)
{
    for (int i = 0; i < COUNT(rows); i++)
        for (int family = 0; family < 2; family++) {
            bench b;
            double p[3];
            begin_bench(&b, family, rows[i].closed);
            const batten_status status = turn(&b, family, rows[i].ranked, rows[i].reversed);
            if (status == BATTEN_OUT_OF_MEMORY) { /* half-way it is no curve to try again */
                end_bench(&b);
                continue;
            }
            CHECK_OK(status);
            for (int k = 0; k < 3 + rows[i].closed; k++)
                CHECK_NEAR(b.curve.at[k], rows[i].at[k], 1e-15);
            CHECK_OK(batten_curve_evaluate(b.curve.curve, 0, 0, p));
            CHECK_NEAR(p[0], rows[i].start[0], 1e-14);
            CHECK_NEAR(p[1], rows[i].start[1], 1e-14);
            CHECK_OK(batten_curve_evaluate(b.curve.curve, 1, 0, p));
            CHECK_NEAR(p[0], rows[i].end[0], 1e-14);
            CHECK_NEAR(p[1], rows[i].end[1], 1e-14);
            CHECK_NEAR(b.net.report.cut, rows[i].cut, 1e-14);
            CHECK_INT(b.net.report.cut_count, rows[i].cut_count);
            CHECK_INT(b.net.report.reversed_count, rows[i].reversed);
            CHECK(b.curve.moved == 0);
            end_bench(&b);
        }
}

TEST(a_seam_that_is_open_meets_halfway_when_the_curve_begins_elsewhere)
{
    static const double open[] = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, 0, 0.125, 0};
    static const double corners[] = {0, 0, 0.25, 0.5, 0.75, 1, 1}, ranked[] = {0.25, 0.5, 0.75};
    bench b;
    double p[3];
    begin_bench(&b, 0, true);
    batten_curve_unref(b.curve.curve);
    b.curve.curve = NULL;
    CHECK_OK(
        batten_curve_create((batten_points){3, 5, open}, 1, NULL, corners, &b.curve.curve));
    b.curve.moved = 1;
    const batten_status status = turn(&b, 0, ranked, false);
    if (status != BATTEN_OUT_OF_MEMORY) {
        CHECK_OK(status);
        CHECK_NEAR(b.curve.moved, 1.0625, 1e-15);
        CHECK_OK(batten_curve_evaluate(b.curve.curve, 0.75, 0, p));
        CHECK_NEAR(p[1], 0.0625, 1e-15);
    }
    end_bench(&b);
}

TEST(what_extends_beyond_the_network_is_refused_with_its_length_when_nothing_is_to_be_cut)
{
    static const struct {
        double ranked[3];
        const char *says[2];
    } refused[] = {
        {{0.25, 0.5, 1},
         {"profile 3 extends 2 beyond the network", "guide 3 extends 2 beyond the network"}},
        {{0, 0.5, 0.75},
         {"profile 3 extends 2 beyond the network", "guide 3 extends 2 beyond the network"}},
        {{0.0625, 0.5, 0.5},
         {"profile 3 extends 4 beyond the network", "guide 3 extends 4 beyond the network"}},
    };
    static const double within[] = {0.0625, 0.5, 0.9375};
    for (int family = 0; family < 2; family++)
        for (int i = 0; i <= COUNT(refused); i++) {
            const bool fits = i == COUNT(refused); /* no more than the gap */
            bench b;
            begin_bench(&b, family, false);
            b.options.cut = false;
            const batten_status status =
                turn(&b, family, fits ? within : refused[i].ranked, false);
            if (status == BATTEN_OUT_OF_MEMORY) { /* half-way it is no curve to try again */
                end_bench(&b);
                continue;
            }
            CHECK_STATUS(status, fits ? BATTEN_OK : BATTEN_NOT_COMPATIBLE);
            if (fits)
                CHECK_NEAR(b.net.report.cut, 0.5, 1e-15);
            else
                CHECK_MESSAGE(refused[i].says[family]);
            end_bench(&b);
        }
}

TEST(a_point_has_parameters_but_is_not_turned)
{
    static const double ranked[] = {0.9, 0.5, 0.1};
    bench b;
    begin_bench(&b, 0, false);
    b.curve.point = true;
    CHECK_OK(turn(&b, 0, ranked, true));
    CHECK(b.curve.at && b.net.report.reversed_count == 0 && b.net.report.cut_count == 0);
    end_bench(&b);
}
