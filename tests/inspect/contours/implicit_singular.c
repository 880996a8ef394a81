/* Singular points of curves f(x, y) = 0: their places and kinds at any size, each once. */
#include "support/test.h"

#include <batten/contours.h>
#include <math.h>

/* With X = (x - at) / size and Y = (y + at) / (3 size). */
typedef struct {
    int kind;
    double at, size;
} curve;

enum { CROSSING, ISOLATED, CUSP, TWO_CROSSINGS, SMOOTH };

static double value(const void *context, double x, double y, double *g)
{
    const curve *c = context;
    const double X = (x - c->at) / c->size, Y = (y + c->at) / (3 * c->size);
    double f = 0, along[2] = {0, 0};
    switch (c->kind) {
    case CROSSING:
        f = X * X - Y * Y;
        along[0] = 2 * X, along[1] = -2 * Y;
        break;
    case ISOLATED:
        f = X * X + Y * Y;
        along[0] = 2 * X, along[1] = 2 * Y;
        break;
    case CUSP:
        f = Y * Y - X * X * X;
        along[0] = -3 * X * X, along[1] = 2 * Y;
        break;
    case TWO_CROSSINGS: /* two parabolas that cross at X = +-1/2, Y = 0 */
        f = Y * Y - (X * X - 0.25) * (X * X - 0.25);
        along[0] = -4 * X * (X * X - 0.25), along[1] = 2 * Y;
        break;
    case SMOOTH:
        f = X * X + Y * Y - 0.3;
        along[0] = 2 * X, along[1] = 2 * Y;
        break;
    }
    g[0] = along[0] / c->size;
    g[1] = along[1] / (3 * c->size);
    return f;
}

static batten_trace trace_of(const curve *c, int cells)
{
    const batten_box window = {{c->at - c->size, -c->at - 3 * c->size, 0},
                               {c->at + c->size, -c->at + 3 * c->size, 0}};
    batten_trace trace = {{0, NULL}, 0, NULL};
    CHECK_OK(batten_trace_field(value, c, window, cells, 1e-3 * c->size, &trace));
    return trace;
}

static const struct {
    int kind, count;
    double x; /* of the last one */
    batten_singular_kind found;
} rows[] = {{CROSSING, 1, 0, BATTEN_SINGULAR_CROSSING},
            {ISOLATED, 1, 0, BATTEN_SINGULAR_ISOLATED},
            {CUSP, 1, 0, BATTEN_SINGULAR_CUSP},
            {TWO_CROSSINGS, 2, 0.5, BATTEN_SINGULAR_CROSSING},
            {SMOOTH, 0, 0, BATTEN_SINGULAR_CROSSING}};

/* In nodes of the grid (an even count) or within cells. */
TEST(singular_points_are_found_once_at_any_size_and_place)
{
    static const double sizes[] = {1e-4, 1, 1e4}, places[] = {0, 0.3, -50};
    for (int r = 0; r < COUNT(rows); r++)
        for (int i = 0; i < 9; i++) {
            const double size = sizes[i / 3], at = places[i % 3] * size;
            const curve c = {rows[r].kind, at, size};
            batten_trace trace = trace_of(&c, i % 2 ? 24 : 25);
            const double allowed = (rows[r].found == BATTEN_SINGULAR_CUSP ? 2e-3 : 1e-8) * size;
            CHECK_INT(trace.singular_count, rows[r].count);
            for (int k = 0; k < trace.singular_count; k++) {
                const double x = (trace.singular[k].x - at) / size;
                CHECK_NEAR(fabs(x) * size, rows[r].x * size, allowed);
                CHECK_NEAR(trace.singular[k].y, -at, allowed);
                CHECK_INT(trace.singular[k].kind, rows[r].found);
            }
            batten_trace_release(&trace);
        }
}

TEST(singular_points_come_row_by_row)
{
    const curve c = {TWO_CROSSINGS, 0, 1};
    batten_trace trace = trace_of(&c, 25);
    CHECK_INT(trace.singular_count, 2);
    CHECK_NEAR(trace.singular[0].x, -0.5, 1e-9);
    CHECK_NEAR(trace.singular[1].x, 0.5, 1e-9);
    batten_trace_release(&trace);
    CHECK_INT(trace.singular_count, 0);
}
