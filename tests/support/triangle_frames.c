#include "support/triangle_frames.h"

static const double corners[3][2] = {{0.2, 0.1}, {2.1, 0.4}, {0.9, 1.7}};

double value_of(const polynomial *f, double x, double y, int dx, int dy)
{
    double sum = 0;
    for (int a = dx; a <= f->degree; a++)
        for (int b = dy; a + b <= f->degree; b++) {
            double term = f->c[a][b];
            for (int k = 0; k < dx; k++)
                term *= a - k;
            for (int k = 0; k < dy; k++)
                term *= b - k;
            sum += term * pow(x, a - dx) * pow(y, b - dy);
        }
    return sum;
}

polynomial random_polynomial(test_random *random, int degree)
{
    polynomial f = {.degree = degree};
    for (int a = 0; a <= degree; a++)
        for (int b = 0; a + b <= degree; b++)
            f.c[a][b] = test_random_in(random, -1, 1);
    return f;
}

/* A curve of degree 4 through what `at` says at five even parameters: of polynomials of degree
 * 4 it is the polynomial. */
typedef void sample(const void *data, int e, double t, double out[3]);
static batten_status curve_of(sample *at, const void *data, int e, batten_curve **out)
{
    /* Bezier points of degree 4 from values at 0, 1/4 ... 1. */
    static const double inverse[5][5] = {{1, 0, 0, 0, 0},
                                         {-13 / 12.0, 4, -3, 4 / 3.0, -1 / 4.0},
                                         {13 / 18.0, -32 / 9.0, 20 / 3.0, -32 / 9.0, 13 / 18.0},
                                         {-1 / 4.0, 4 / 3.0, -3, 4, -13 / 12.0},
                                         {0, 0, 0, 0, 1}};
    static const double knots[10] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
    double points[15] = {0};
    for (int k = 0; k < 5; k++) {
        double value[3];
        at(data, e, k / 4.0, value);
        for (int i = 0; i < 5; i++)
            for (int c = 0; c < 3; c++)
                points[3 * i + c] += inverse[i][k] * value[c];
    }
    return batten_curve_create((batten_points){3, 5, points}, 4, NULL, knots, out);
}

static void side_point(int e, double t, double out[2])
{
    for (int c = 0; c < 2; c++)
        out[c] = (1 - t) * corners[(e + 1) % 3][c] + t * corners[(e + 2) % 3][c];
}

static void graph_point(const void *data, int e, double t, double out[3])
{
    side_point(e, t, out);
    out[2] = value_of(data, out[0], out[1], 0, 0);
}

/* The derivative towards the opposite corner, as the ribbon of a side wants it. */
static void graph_slope(const void *data, int e, double t, double out[3])
{
    double p[2];
    side_point(e, t, p);
    for (int c = 0; c < 2; c++)
        out[c] = corners[e][c] - p[c];
    out[2] =
        value_of(data, p[0], p[1], 1, 0) * out[0] + value_of(data, p[0], p[1], 0, 1) * out[1];
}

static void frame_make(sample *point, sample *slope, const void *data, frame *out)
{
    *out = (frame){{NULL}, {NULL}, {{NULL, NULL, NULL}}};
    for (int e = 0; e < 3; e++) {
        CHECK_OK(curve_of(point, data, e, &out->curves[e]));
        if (slope)
            CHECK_OK(curve_of(slope, data, e, &out->slopes[e]));
        out->ribbons[e] = (batten_ribbon){out->curves[e], out->slopes[e], NULL};
    }
}

void frame_free(frame *f)
{
    for (int e = 0; e < 3; e++) {
        batten_curve_unref(f->curves[e]);
        batten_curve_unref(f->slopes[e]);
    }
}

void polynomial_frame(const polynomial *f, bool smooth, frame *out)
{
    frame_make(graph_point, smooth ? graph_slope : NULL, f, out);
}

static void space_point(const void *data, int e, double t, double out[3])
{
    const double *bend = (const double *)data + 3 * e;
    side_point(e, t, out);
    out[2] = 0.3 * out[0] - 0.2 * out[1] * out[1];
    for (int c = 0; c < 3; c++)
        out[c] += t * (1 - t) * bend[c];
}

/* Cross the tangent, leaning with t; at the ends in the plane of both curves. */
static batten_status space_slope(const frame *data, int e, batten_curve **out)
{
    double ends[2][3], a[6], b[6], C[6], points[9];
    static const double knots[6] = {0, 0, 0, 1, 1, 1};
    CHECK_OK(batten_curve_evaluate(data->curves[(e + 2) % 3], 1, 1, a));
    CHECK_OK(batten_curve_evaluate(data->curves[(e + 1) % 3], 0, 1, b));
    for (int end = 0; end < 2; end++) {
        CHECK_OK(batten_curve_evaluate(data->curves[e], end, 1, C));
        for (int c = 0; c < 3; c++)
            ends[end][c] = 0.7 * (end ? b[3 + c] : -a[3 + c]) + 0.4 * C[3 + c];
    }
    for (int c = 0; c < 3; c++) {
        points[c] = ends[0][c];
        points[3 + c] = (ends[0][c] + ends[1][c]) / 2 + (c == 2 ? 0.5 : 0.1);
        points[6 + c] = ends[1][c];
    }
    return batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, out);
}

void space_frame(test_random *random, frame *out)
{
    double bend[3][3];
    for (int e = 0; e < 3; e++)
        for (int c = 0; c < 3; c++)
            bend[e][c] = test_random_in(random, -0.4, 0.4);
    frame_make(space_point, NULL, bend, out);
    for (int e = 0; e < 3; e++) {
        CHECK_OK(space_slope(out, e, &out->slopes[e]));
        out->ribbons[e].slope = out->slopes[e];
    }
}
