/* Sums of energy over quintic spans, and what Newton needs of them. */
#include "shape/bent/energy_sum.h"

#include "support/generate.h"
#include "support/test.h"

enum { NODES = 4, MOST = NODES * 9 };

/* A curve of few nodes in which all is unknown, numbered in order. */
typedef struct {
    bat_energy_curve curve;
    double x[MOST], step[NODES], frame[MOST], gradient[MOST], length_gradient[MOST];
    double matrix[MOST * MOST];
    int unknown[MOST];
    bat_energy_change span;
    bat_energy_task task;
    bat_energy_search search;
} bench;

static void begin_bench(bench *b, int d, bool closed, batten_energy kind)
{
    *b = (bench){.task = {.kind = kind}};
    const int spans = closed ? NODES : NODES - 1, n = NODES * 3 * d;
    b->curve = (bat_energy_curve){.d = d,
                                  .count = NODES,
                                  .spans = spans,
                                  .closed = closed,
                                  .x = b->x,
                                  .step = b->step,
                                  .unknown = b->unknown,
                                  .frame = b->frame,
                                  .unknown_count = n,
                                  .band = n - 1};
    for (int i = 0; i < n; i++)
        b->unknown[i] = i;
    b->search = (bat_energy_search){.task = &b->task,
                                    .curve = &b->curve,
                                    .gradient = b->gradient,
                                    .length_gradient = b->length_gradient,
                                    .matrix = b->matrix,
                                    .span = &b->span};
    bat_energy_fill_basis(&b->search.basis);
}

/* Nodes near those of a circle, not in one plane where there is space. */
static void shake_nodes(bench *b, test_random *random)
{
    const int d = b->curve.d;
    for (int i = 0; i < NODES; i++) {
        const double t = 1.3 * i, place[3][3] = {{cos(t), sin(t), 0.2 * t},
                                                 {-sin(t), cos(t), 0.2},
                                                 {-cos(t), -sin(t), 0}};
        for (int k = 0; k < 3 * d; k++)
            b->x[i * 3 * d + k] = place[k / d][k % d] + test_random_in(random, -0.1, 0.1);
        b->step[i] = 1.3 + 0.1 * i;
    }
}

static double objective(bench *b)
{
    double energy, length, size;
    bat_energy_sum(&b->search, &energy, &length, &size);
    return bat_energy_objective(&b->search, energy, length);
}

/* A quarter of the unit circle in each span of length pi / 2: quintics are a hundred-thousandth off it. */
TEST(energy_and_length_are_those_of_a_circle)
{
    for (int d = 2; d <= 3; d++)
        for (int closed = 0; closed <= 1; closed++) {
            bench b;
            double energy, length, size;
            begin_bench(&b, d, closed, BATTEN_ENERGY_BENDING);
            const double turn = closed ? 4 : 3, quarter = 1.5707963267948966;
            for (int i = 0; i < NODES; i++) {
                const double at[3][2] = {{cos(i * quarter), sin(i * quarter)},
                                         {-sin(i * quarter), cos(i * quarter)},
                                         {-cos(i * quarter), -sin(i * quarter)}};
                for (int k = 0; k < 6; k++)
                    b.x[i * 3 * d + k / 2 * d + k % 2] = 2 * at[k / 2][k % 2] /
                                                         (k < 2   ? 1
                                                          : k < 4 ? 2
                                                                  : 4);
                b.step[i] = 2 * quarter;
            }
            bat_energy_sum(&b.search, &energy, &length, &size);
            CHECK_NEAR(length, 2 * turn * quarter, 2e-3);
            CHECK_NEAR(energy, turn * quarter / 2, 2e-3);
            CHECK(size >= energy && size < 3 * energy);
            CHECK_NEAR(bat_energy_length(&b.curve), length, 1e-12);
            b.task.kind = BATTEN_ENERGY_VARIATION;
            bat_energy_sum(&b.search, &energy, &length, &size);
            CHECK(fabs(energy) < 2e-3 && size > energy);
        }
}

static const struct {
    int d;
    bool closed, invariant;
    batten_energy kind;
    double tension, objective; /* of E = 3 and L = 2 */
} tasks[] = {
    {2, false, false, BATTEN_ENERGY_BENDING, 0, 3},
    {3, true, false, BATTEN_ENERGY_BENDING, 0.7, 4.4},
    {2, true, true, BATTEN_ENERGY_BENDING, 0, 6},
    {3, false, false, BATTEN_ENERGY_VARIATION, 0.7, 4.4},
    {2, true, false, BATTEN_ENERGY_VARIATION, 0, 3},
    {3, true, true, BATTEN_ENERGY_VARIATION, 0, 24},
};

/* The matrix lacks what energy and length do together in a product, which Newton adds. */
TEST(gradient_and_matrix_are_limits_of_differences_along_the_axes_of_the_nodes)
{
    test_random random = test_random_begin("energy sums");
    for (int c = 0; c < COUNT(tasks); c++) {
        bench b;
        const int d = tasks[c].d, n = NODES * 3 * d;
        begin_bench(&b, d, tasks[c].closed, tasks[c].kind);
        b.task.scale_invariant = tasks[c].invariant;
        b.task.tension = tasks[c].tension;
        CHECK_NEAR(bat_energy_objective(&b.search, 3, 2), tasks[c].objective, 1e-14);
        shake_nodes(&b, &random);
        bat_energy_sum(&b.search, &b.search.energy, &b.search.length, &b.search.size);
        bat_energy_differentiate(&b.search);
        double kept[MOST], gradient[MOST], here[MOST];
        memcpy(kept, b.x, sizeof kept);
        memcpy(here, b.gradient, sizeof here);
        for (int u = 0; u < n; u++) {
            const double h = 1e-5, *frame = bat_energy_frame_of(&b.curve, u / (3 * d));
            double side[2];
            for (int s = 0; s < 2; s++) {
                for (int k = 0; k < d; k++)
                    b.x[u / d * d + k] =
                        kept[u / d * d + k] + (s ? h : -h) * frame[k * d + u % d];
                side[s] = objective(&b);
                memcpy(b.x, kept, sizeof kept);
            }
            gradient[u] = (side[1] - side[0]) / (2 * h);
            CHECK_NEAR(here[u], gradient[u], 1e-5 * (1 + fabs(gradient[u])));
        }
    }
}

/* Row u of the band holds the numbers up to its own. */
TEST(the_matrix_of_a_plain_energy_is_the_limit_of_differences_of_its_gradient)
{
    test_random random = test_random_begin("energy matrices");
    for (int c = 0; c < COUNT(tasks); c++) {
        bench b;
        static double matrix[MOST * MOST];
        if (tasks[c].invariant)
            continue;
        begin_bench(&b, tasks[c].d, tasks[c].closed, tasks[c].kind);
        b.task.tension = tasks[c].tension;
        shake_nodes(&b, &random);
        bat_energy_differentiate(&b.search);
        const int d = tasks[c].d, n = NODES * 3 * d;
        double frame[MOST], kept[MOST], side[2][MOST];
        memcpy(matrix, b.matrix, sizeof matrix);
        memcpy(frame, b.frame, sizeof frame);
        memcpy(kept, b.x, sizeof kept);
        for (int u = 0; u < n; u++) {
            /* Along the axes of the node, but the gradient in those of space: only where the tangents stay. */
            if (u / d % 3 == 1)
                continue;
            for (int s = 0; s < 2; s++) {
                for (int k = 0; k < d; k++)
                    b.x[u / d * d + k] =
                        kept[u / d * d + k] +
                        (s ? 1e-5 : -1e-5) * frame[u / (3 * d) * d * d + k * d + u % d];
                bat_energy_differentiate(&b.search);
                memcpy(side[s], b.gradient, sizeof side[s]);
                memcpy(b.x, kept, sizeof kept);
            }
            for (int v = 0; v < n; v++) {
                const int row = u > v ? u : v, column = u > v ? v : u;
                const double difference = (side[1][v] - side[0][v]) / 2e-5;
                CHECK_NEAR(matrix[row * n + column - row + n - 1], difference,
                           1e-4 * (1 + fabs(difference)));
            }
        }
    }
}

TEST(what_is_fixed_has_no_row_and_moves_nothing_else)
{
    test_random random = test_random_begin("fixed numbers");
    bench all, some;
    begin_bench(&all, 2, false, BATTEN_ENERGY_BENDING);
    shake_nodes(&all, &random);
    begin_bench(&some, 2, false, BATTEN_ENERGY_BENDING);
    memcpy(some.x, all.x, sizeof all.x);
    memcpy(some.step, all.step, sizeof all.step);
    int count = 0, of[MOST];
    for (int i = 0; i < NODES * 6; i++) {
        some.unknown[i] = i % 6 == 0 || i % 5 == 2 ? -1 : count;
        if (some.unknown[i] >= 0)
            of[count++] = i;
    }
    some.curve.unknown_count = count;
    some.curve.band = count - 1;
    bat_energy_differentiate(&all.search);
    bat_energy_differentiate(&some.search);
    for (int u = 0; u < count; u++) {
        CHECK(some.gradient[u] == all.gradient[of[u]]);
        for (int v = 0; v <= u; v++)
            CHECK(some.matrix[u * count + v - u + count - 1] ==
                  all.matrix[of[u] * 24 + of[v] - of[u] + 23]);
    }
}

TEST(the_axes_of_a_node_are_square_and_the_first_is_its_tangent)
{
    test_random random = test_random_begin("axes");
    for (int d = 2; d <= 3; d++) {
        bench b;
        begin_bench(&b, d, true, BATTEN_ENERGY_BENDING);
        shake_nodes(&b, &random);
        bat_energy_differentiate(&b.search);
        for (int i = 0; i < NODES; i++) {
            const double *frame = bat_energy_frame_of(&b.curve, i),
                         *tangent = b.x + (i * 3 + 1) * d;
            double norm = 0;
            for (int k = 0; k < d; k++)
                norm = hypot(norm, tangent[k]);
            for (int k = 0; k < d; k++)
                CHECK_NEAR(frame[k * d], tangent[k] / norm, 1e-15);
            for (int a = 0; a < d; a++)
                for (int c = 0; c < d; c++) {
                    double dot = 0;
                    for (int k = 0; k < d; k++)
                        dot += frame[k * d + a] * frame[k * d + c];
                    CHECK_NEAR(dot, a == c, 1e-15);
                }
        }
    }
}

/* The quintic with points, first and second derivatives of a polynomial of degree 5 is that polynomial. */
TEST(bezier_points_of_a_span_are_those_of_its_polynomial)
{
    bench b;
    double points[12];
    begin_bench(&b, 2, false, BATTEN_ENERGY_BENDING);
    for (int i = 0; i < 2; i++) {
        const double t = 2 + 0.5 * i;
        const double at[6] = {t * t * t * t * t, t * t, 5 * t * t * t * t, 2 * t,
                              20 * t * t * t,    2};
        memcpy(b.x + 6 * i, at, sizeof at);
    }
    b.step[0] = 0.5;
    bat_energy_bezier(&b.curve, 0, points);
    /* By the blossom: t^5 has the product of five arguments, t^2 the mean of products of two. */
    for (int i = 0; i <= 5; i++) {
        const double product = pow(2, 5 - i) * pow(2.5, i);
        const double pairs =
            (0.5 * (5 - i) * (4 - i) * 4 + i * (5 - i) * 5 + 0.5 * i * (i - 1) * 6.25) / 10;
        CHECK_NEAR(points[2 * i], product, 1e-12);
        CHECK_NEAR(points[2 * i + 1], pairs, 1e-13);
    }
}
