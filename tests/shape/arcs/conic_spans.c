/* Single spans of conics: legs by the law of sines, weights by the curvatures, arcs by their radius. */
#include "shape/arcs/conic_spans.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;

/* A span from (2, 1) over `l` along a chord that is turned by 0.4. */
typedef struct {
    double start[2], end[2], t0[2], t1[2];
    bat_conic_span span;
    bat_conic_piece pieces[16];
    batten_curve_conics_options options;
    bat_conic_fit fit;
} bench;

static void begin_bench(bench *b, double l, double alpha, double beta)
{
    *b = (bench){.start = {2, 1}, .options = batten_curve_conics_defaults()};
    b->end[0] = 2 + l * cos(0.4);
    b->end[1] = 1 + l * sin(0.4);
    b->t0[0] = cos(0.4 + alpha);
    b->t0[1] = sin(0.4 + alpha);
    b->t1[0] = cos(0.4 + beta);
    b->t1[1] = sin(0.4 + beta);
    b->span = (bat_conic_span){b->start, b->end, b->t0, b->t1, l, alpha, beta, 0, 0};
    b->options.kind = BATTEN_CONICS_PAIRS;
    b->fit = (bat_conic_fit){.options = &b->options, .pieces = b->pieces};
}

TEST(legs_lead_to_where_the_tangents_meet)
{
    static const double rows[][2] = {{0.3, -0.3}, {-0.8, 0.2}, {1.2, -1.7}, {-0.1, 1.5}};
    for (int i = 0; i < COUNT(rows); i++) {
        bench b;
        double leg[2];
        begin_bench(&b, 3, rows[i][0], rows[i][1]);
        CHECK(bat_conic_find_legs(&b.span, &leg[0], &leg[1]));
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(b.start[k] + leg[0] * b.t0[k], b.end[k] - leg[1] * b.t1[k], 1e-13);
    }
}

TEST(tangents_that_meet_nowhere_too_far_off_or_too_unevenly_have_no_legs)
{
    const double far = acos(1 / 40.), near = 0.01, uneven = asin(20 * sin(near));
    const struct {
        double alpha, beta;
        bool are;
    } rows[] = {{0.3, 0.3, false},
                {-0.3, -0.2, false},
                {0, -0.2, false},
                {0.3, 0, false},
                {far - 1e-4, -far + 1e-4, true},
                {far + 1e-4, -far - 1e-4, false},
                {near, -uneven + 1e-5, true},
                {near, -uneven - 1e-5, false},
                {uneven - 1e-5, -near, true},
                {uneven + 1e-5, -near, false},
                {1.6, -1.6, false},
                {3, -0.2, false}};
    for (int i = 0; i < COUNT(rows); i++) {
        bench b;
        double leg[2];
        begin_bench(&b, 7, rows[i].alpha, rows[i].beta);
        CHECK_INT(bat_conic_find_legs(&b.span, &leg[0], &leg[1]), rows[i].are);
    }
}

TEST(the_curvature_of_a_conic_is_that_of_its_circle_and_0_of_a_line)
{
    const double h = 0.6, r = 2;
    const bat_conic_piece
        arc = {{r, 0}, {r, r * tan(h)}, {r * cos(2 * h), r * sin(2 * h)}, cos(h)},
        back = {{r * cos(2 * h), r * sin(2 * h)}, {r, r * tan(h)}, {r, 0}, cos(h)},
        line = {{0, 0}, {1, 1}, {2, 2}, 1}, point = {{0, 0}, {0, 0}, {1, 0}, 1},
        parabola = {{0, 0}, {1, 0}, {2, 1}, 1}; /* y = x^2 / 4 */
    for (int end = 0; end < 2; end++) {
        CHECK_NEAR(bat_conic_curvature(&arc, end), 1 / r, 1e-15);
        CHECK_NEAR(bat_conic_curvature(&back, end), -1 / r, 1e-15);
        CHECK_NEAR(bat_conic_curvature(&line, end), 0, 0);
        CHECK_NEAR(bat_conic_curvature(&point, end), 0, 0);
    }
    CHECK_NEAR(bat_conic_curvature(&parabola, false), 0.5, 1e-15);
    CHECK_NEAR(bat_conic_curvature(&parabola, true), 0.5 / (2 * sqrt(2)), 1e-15);
}

/* Both halves meet on the chord, in the direction of the cubic over it, and keep what curvatures they can. */
static void check_s(double alpha, double beta, double k0, double k1, bool wrong0, bool wrong1)
{
    bench b;
    const double l = 3, share = alpha / (alpha + beta), turn = 0.4 - share * beta;
    begin_bench(&b, l, alpha, beta);
    b.span.k0 = wrong0 ? -k0 : k0;
    b.span.k1 = wrong1 ? -k1 : k1;
    for (int call = 0; call < 2; call++)
        bat_conic_add_s(&b.fit, 5 + call, &b.span);
    CHECK_INT(b.fit.piece_count, 4);
    CHECK_INT(b.fit.report.inflections, 2);
    CHECK_INT(b.fit.report.fallen_back, wrong0 || wrong1 ? 2 : 0);
    CHECK_INT(b.fit.report.first_fallen_back, wrong0 || wrong1 ? 5 : 0);
    const bat_conic_piece *p = b.pieces;
    const double T[2] = {cos(turn), sin(turn)};
    for (int k = 0; k < 2; k++) {
        const double joint = b.start[k] + share * (b.end[k] - b.start[k]);
        CHECK_NEAR(p[0].a[k], b.start[k], 0);
        CHECK_NEAR(p[1].c[k], b.end[k], 0);
        CHECK_NEAR(p[0].c[k], joint, 1e-15);
        CHECK_NEAR(p[1].a[k], joint, 1e-15);
    }
    /* Their legs run along the tangents, forwards. */
    const double *from[4] = {p[0].a, p[0].b, p[1].a, p[1].b},
                 *to[4] = {p[0].b, p[0].c, p[1].b, p[1].c}, *along[4] = {b.t0, T, T, b.t1};
    for (int i = 0; i < 4; i++) {
        const double d[2] = {to[i][0] - from[i][0], to[i][1] - from[i][1]};
        CHECK_NEAR(d[0] * along[i][1] - d[1] * along[i][0], 0, 1e-14);
        CHECK(d[0] * along[i][0] + d[1] * along[i][1] > 0);
    }
    for (int i = 0; i < 2; i++)
        if (i ? wrong1 : wrong0)
            CHECK_NEAR(p[i].w,
                       hypot(p[i].c[0] - p[i].a[0], p[i].c[1] - p[i].a[1]) /
                           (hypot(p[i].b[0] - p[i].a[0], p[i].b[1] - p[i].a[1]) +
                            hypot(p[i].c[0] - p[i].b[0], p[i].c[1] - p[i].b[1])),
                       1e-15);
        else
            CHECK_NEAR(bat_conic_curvature(&p[i], i == 1), i ? k1 : k0, 1e-13);
}

TEST(an_s_is_two_conics_with_the_curvatures_of_its_ends_where_these_bend_that_way)
{
    for (int wrong = 0; wrong < 4; wrong++) {
        check_s(0.5, 0.5, -0.4, 0.7, wrong & 1, wrong & 2);
        check_s(0.3, 0.9, -0.9, 0.2, wrong & 1, wrong & 2);
        check_s(-0.6, -0.2, 0.3, -0.5, wrong & 1, wrong & 2);
    }
}

/* From t0 to t1 by equal angles there is one circle, of radius l / (2 sin angle). */
TEST(a_biarc_of_one_circle_is_conics_of_a_third_of_a_turn_at_most)
{
    for (int i = 1; i <= 16; i++) {
        bench b;
        const double angle = i * 10 * pi / 180, r = 3 / (2 * sin(angle));
        begin_bench(&b, 3, angle, -angle);
        for (int call = 0; call < 2; call++) {
            b.fit.piece_count = 0;
            CHECK_OK(bat_conic_add_biarc(&b.fit, 7 + call, &b.span));
        }
        CHECK_INT(b.fit.report.arcs, 2);
        CHECK_INT(b.fit.report.first_arcs, 7);
        const int count = b.fit.piece_count;
        CHECK(count >= 2 * angle / (2 * pi / 3) - 1e-9 &&
              count <= 2 * angle / (2 * pi / 3) + 2);
        double turned = 0;
        for (int k = 0; k < count; k++) {
            const bat_conic_piece *p = &b.pieces[k];
            CHECK(p->w >= 0.5 - 1e-12);
            turned += 2 * acos(p->w);
            for (int end = 0; end < 2; end++)
                CHECK_NEAR(bat_conic_curvature(p, end), -1 / r, 1e-11);
            for (int c = 0; c < 2; c++) {
                CHECK_NEAR(p->a[c], k ? p[-1].c[c] : b.start[c], 1e-13);
                if (k + 1 == count)
                    CHECK_NEAR(p->c[c], b.end[c], 0);
            }
        }
        CHECK_NEAR(turned, 2 * angle, 1e-7);
    }
}

TEST(a_line_is_a_conic_with_its_middle)
{
    bench b;
    begin_bench(&b, 4, 0, 0);
    bat_conic_add_line(&b.fit, &b.span);
    CHECK_INT(b.fit.piece_count, 1);
    for (int k = 0; k < 2; k++) {
        CHECK_NEAR(b.pieces[0].a[k], b.start[k], 0);
        CHECK_NEAR(b.pieces[0].b[k], (b.start[k] + b.end[k]) / 2, 1e-15);
        CHECK_NEAR(b.pieces[0].c[k], b.end[k], 0);
    }
    CHECK_NEAR(b.pieces[0].w, 1, 0);
}
