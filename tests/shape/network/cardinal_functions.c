/* Functions that are 1 at one node and 0 at the others. */
#include "shape/network/gordon.h"

#include "support/test.h"

/* A network that is but parameters of nodes along the curves of one family. */
typedef struct {
    bat_network net;
    batten_surface_gordon_options options;
    double parameters[16];
} bench;

static void begin_bench(bench *b, int family, int nodes, batten_gordon_blend blend)
{
    static const double uneven[] = {0, 0.1, 0.35, 0.6, 1};
    *b = (bench){.options = batten_surface_gordon_defaults()};
    b->options.blend = blend;
    b->net.options = &b->options;
    b->net.family[family].parameters = b->parameters;
    b->net.family[family].count = 99; /* of its own it needs no number */
    b->net.family[1 - family].count = nodes;
    for (int i = 0; i < nodes; i++)
        b->parameters[i] = nodes == 5 ? uneven[i] : i / (nodes - 1.0);
}

static double value_at(const bat_spline *s, int function, double u, int order)
{
    batten_curve *curve = NULL;
    double points[64], out[4];
    for (int i = 0; i < s->count; i++)
        points[i] = s->values[(size_t)i * s->width + (size_t)function];
    CHECK_OK(batten_curve_create((batten_points){1, s->count, points}, s->degree, NULL,
                                 s->knots, &curve));
    CHECK_OK(batten_curve_evaluate(curve, u, order, out));
    batten_curve_unref(curve);
    return out[order];
}

/* Of an open family 5 functions, of a periodic one 4, which close with two derivatives. */
TEST(each_function_is_1_at_its_node_and_0_at_the_others_and_they_sum_to_1)
{
    for (int family = 0; family < 2; family++)
        for (int periodic = 0; periodic < 2; periodic++) {
            bench b;
            bat_spline s = {0};
            begin_bench(&b, family, 5, BATTEN_GORDON_SPLINE);
            CHECK_OK(bat_network_make_cardinal(&b.net, family, periodic, &s));
            CHECK_INT(s.degree, 3);
            CHECK_INT((int)s.width, periodic ? 4 : 5);
            for (int k = 0; k < (int)s.width; k++)
                for (int i = 0; i < 5; i++)
                    CHECK_NEAR(value_at(&s, k, b.parameters[i], 0), k == (periodic ? i % 4 : i),
                               1e-13);
            for (int i = 0; i <= 20; i++) {
                double sum = 0;
                for (int k = 0; k < (int)s.width; k++)
                    sum += value_at(&s, k, i / 20.0, 0);
                CHECK_NEAR(sum, 1, 1e-13);
            }
            for (int k = 0; k < 4 && periodic; k++)
                for (int order = 1; order <= 2; order++)
                    CHECK_NEAR(value_at(&s, k, 0, order), value_at(&s, k, 1, order), 1e-9);
            bat_spline_free(&s);
        }
}

TEST(linear_functions_are_hats_and_polynomials_are_those_of_lagrange)
{
    for (int i = 0; i <= 40; i++) {
        const double u = i / 40.0;
        for (int k = 0; k < 5; k++) {
            bench b;
            bat_spline s = {0};
            begin_bench(&b, 0, 5, BATTEN_GORDON_LINEAR);
            CHECK_OK(bat_network_make_cardinal(&b.net, 0, false, &s));
            CHECK_INT(s.degree, 1);
            const double *t = b.parameters;
            double hat = 0, product = 1;
            if (k > 0 && u >= t[k - 1] && u <= t[k])
                hat = (u - t[k - 1]) / (t[k] - t[k - 1]);
            if (k < 4 && u > t[k] && u <= t[k + 1])
                hat = (t[k + 1] - u) / (t[k + 1] - t[k]);
            hat = u == t[k] ? 1 : hat;
            CHECK_NEAR(value_at(&s, k, u, 0), hat, 1e-14);
            bat_spline_free(&s);
            begin_bench(&b, 0, 5, BATTEN_GORDON_LAGRANGE);
            CHECK_OK(bat_network_make_cardinal(&b.net, 0, false, &s));
            CHECK_INT(s.degree, 4);
            for (int l = 0; l < 5; l++)
                product *= l == k ? 1 : (u - t[l]) / (t[k] - t[l]);
            CHECK_NEAR(value_at(&s, k, u, 0), product, 1e-11);
            bat_spline_free(&s);
        }
    }
}

TEST(polynomials_take_12_nodes_and_not_13)
{
    bench b;
    bat_spline s = {0};
    begin_bench(&b, 1, 12, BATTEN_GORDON_LAGRANGE);
    CHECK_OK(bat_network_make_cardinal(&b.net, 1, false, &s));
    CHECK_INT(s.degree, 11);
    bat_spline_free(&s);
    begin_bench(&b, 1, 13, BATTEN_GORDON_LAGRANGE);
    CHECK_STATUS(bat_network_make_cardinal(&b.net, 1, false, &s), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("polynomials through 13 curves swing; 12 are the limit");
}
