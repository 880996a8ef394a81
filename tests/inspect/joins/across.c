/* The way across an edge: curvature and rate of graphs in crooked parameters, in closed form. */
#include "inspect/joins/across.h"
#include "support/test.h"

/* The derivatives at (0, 0) of (x, y, f(x, y)) with x = u + u v / 2 + u^2 / 3, y = v / 2 + u / 5 + u^2,
 * f = a x^2 + b x y + c y^2 + d x^3 + e x^2 y + g x y^2 + h y^3: by the polynomials in u and v. */
typedef struct {
    double a, b, c, d, e, g, h;
} graph;

/* Polynomials of degree 3 in u and v: p[i][j] of u^i v^j. */
typedef double poly[4][4];

static void multiply(poly p, poly q, poly out)
{
    poly r = {{0}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; i + j < 4; j++)
            for (int k = 0; i + j + k < 4; k++)
                for (int l = 0; i + j + k + l < 4; l++)
                    r[i + k][j + l] += p[i][j] * q[k][l];
    memcpy(out, r, sizeof r);
}

static void add(poly to, double factor, poly p)
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            to[i][j] += factor * p[i][j];
}

static void lay_graph(const graph *f, double s[10][3])
{
    poly x = {{0}}, y = {{0}}, z = {{0}}, xx, xy, yy, third;
    x[1][0] = 1;
    x[1][1] = 0.5;
    x[2][0] = 1 / 3.;
    y[0][1] = 0.5;
    y[1][0] = 0.2;
    y[2][0] = 1;
    multiply(x, x, xx);
    multiply(x, y, xy);
    multiply(y, y, yy);
    add(z, f->a, xx);
    add(z, f->b, xy);
    add(z, f->c, yy);
    multiply(xx, x, third);
    add(z, f->d, third);
    multiply(xx, y, third);
    add(z, f->e, third);
    multiply(xy, y, third);
    add(z, f->g, third);
    multiply(yy, y, third);
    add(z, f->h, third);
    static const int order[10][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1},
                                     {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};
    static const double factorial[4] = {1, 1, 2, 6};
    for (int k = 0; k < 10; k++) {
        const int i = order[k][0], j = order[k][1];
        s[k][0] = factorial[i] * factorial[j] * x[i][j];
        s[k][1] = factorial[i] * factorial[j] * y[i][j];
        s[k][2] = factorial[i] * factorial[j] * z[i][j];
    }
}

TEST(curvature_and_rate_across_an_edge_are_those_of_the_section_square_to_it)
{
    const graph f = {0.7, -0.4, 0.3, 1.1, -0.6, 0.9, 0.2};
    double s[10][3];
    lay_graph(&f, s);
    for (int i = 0; i < 12; i++) {
        const double angle = 0.5 * i + 0.1, c = cos(angle), sn = sin(angle);
        const batten_vec3 along = {3 * c, 3 * sn, 0}, inward = {sn + 0.3 * c, -c + 0.3 * sn, 0};
        const double x = sn, y = -c; /* square to the edge, to the side of `inward` */
        bat_across across;
        CHECK(bat_across_edge(3, s[0], along, inward, &across));
        CHECK_NEAR(across.into.x, x, 1e-14);
        CHECK_NEAR(across.into.y, y, 1e-14);
        CHECK_NEAR(across.normal.z, 1, 1e-14);
        CHECK_NEAR(across.curvature.z, 2 * (f.a * x * x + f.b * x * y + f.c * y * y), 1e-13);
        CHECK_NEAR(across.rate.z,
                   6 * (f.d * x * x * x + f.e * x * x * y + f.g * x * y * y + f.h * y * y * y),
                   1e-12);
    }
}

TEST(a_surface_without_a_tangent_plane_has_no_way_across)
{
    double s[10][3] = {{0}};
    bat_across across;
    s[1][0] = 1;
    s[2][0] = -2;
    CHECK(!bat_across_edge(3, s[0], (batten_vec3){1, 0, 0}, (batten_vec3){0, 1, 0}, &across));
    s[2][1] = 1;
    CHECK(bat_across_edge(3, s[0], (batten_vec3){1, 0, 0}, (batten_vec3){0, 1, 0}, &across));
    CHECK(!bat_across_edge(3, s[0], (batten_vec3){0, 0, 1}, (batten_vec3){0, 1, 0}, &across));
}
