/*
 * How the cost of triangles grows: `batten-bench-meshes` lists the kinds of faces;
 * `batten-bench-meshes FACE CHORD` prints how many triangles one has for a chord. bench/meshes
 * runs them all, and counts instructions.
 */
#include <batten/batten.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "bench: %s\n", batten_message());
    exit(1);
}

/* ---- a surface (u, v, a u^2 + b v^2), and curves on it ---- */

typedef struct {
    const char *name;
    double a, b;
} kind;

static const kind kinds[] = {{"plane", 0, 0}, {"trough", 0.5, 0}, {"bowl", 0.5, 0.4}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static batten_surface *make_surface(const kind *face)
{
    static const double knots[] = {-2, -2, -2, 2, 2, 2};
    /* The control points of t and of t^2 over [-2, 2]. */
    static const double first[3] = {-2, 0, 2}, second[3] = {4, -4, 4};
    const batten_axis axis = {2, 3, knots, false};
    double points[27];
    batten_surface *surface = NULL;
    for (int i = 0; i < 9; i++) {
        points[3 * i] = first[i / 3];
        points[3 * i + 1] = first[i % 3];
        points[3 * i + 2] = face->a * second[i / 3] + face->b * second[i % 3];
    }
    must(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

enum { PIECES = 96, DEGREE = 6, POINTS = PIECES * DEGREE + 1 };

/* The control points, of degree 6, of the product of two cubics. */
static void multiply(const double *p, const double *q, double *product)
{
    static const double choose_3[4] = {1, 3, 3, 1}, choose_6[7] = {1, 6, 15, 20, 15, 6, 1};
    memset(product, 0, 7 * sizeof *product);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            product[i + j] += choose_3[i] * choose_3[j] / choose_6[i + j] * p[i] * q[j];
}

/* A place on the border, and the speed there. */
static void border(double radius, double angle, double place[2], double speed[2])
{
    const double r = radius + 0.1 * sin(11 * angle), dr = 1.1 * cos(11 * angle);
    place[0] = r * cos(angle);
    place[1] = r * sin(angle);
    speed[0] = dr * cos(angle) - place[1];
    speed[1] = dr * sin(angle) + place[0];
}

/* A closed curve around the origin in (u, v), of cubics, and the same on the surface. */
static void make_border(const kind *face, double radius, batten_curve **flat,
                        batten_curve **lifted)
{
    static const double one[4] = {1, 1, 1, 1};
    static double uv[POINTS][2], xyz[POINTS][3], knots[POINTS + DEGREE + 1];
    const double step = 2 * acos(-1) / PIECES;
    for (int i = 0; i < PIECES; i++) {
        double ends[2][2], speeds[2][2], cubic[2][4], product[3][7];
        for (int k = 0; k < 2; k++)
            border(radius, (i + k) % PIECES * step, ends[k], speeds[k]);
        for (int d = 0; d < 2; d++) {
            cubic[d][0] = ends[0][d];
            cubic[d][1] = ends[0][d] + speeds[0][d] * step / 3;
            cubic[d][2] = ends[1][d] - speeds[1][d] * step / 3;
            cubic[d][3] = ends[1][d];
            multiply(cubic[d], cubic[d], product[d]);
        }
        for (int j = 0; j <= DEGREE; j++)
            xyz[DEGREE * i + j][2] = face->a * product[0][j] + face->b * product[1][j];
        for (int d = 0; d < 2; d++) {
            multiply(cubic[d], one, product[2]);
            for (int j = 0; j <= DEGREE; j++)
                uv[DEGREE * i + j][d] = xyz[DEGREE * i + j][d] = product[2][j];
        }
    }
    for (int i = 0; i < POINTS + DEGREE + 1; i++)
        knots[i] = i ? fmin((i - 1) / DEGREE, PIECES) : 0;
    must(batten_curve_create((batten_points){2, POINTS, uv[0]}, DEGREE, NULL, knots, flat));
    must(batten_curve_create((batten_points){3, POINTS, xyz[0]}, DEGREE, NULL, knots, lifted));
}

/* Between two borders. */
static batten_body *make_body(const kind *face)
{
    static const batten_body_loop loops[2] = {{0, 1}, {1, 1}};
    static const batten_body_shell shell = {0, 1, false};
    batten_curve *flat[2], *lifted[2];
    batten_surface *surface = make_surface(face);
    double vertices[2][3];
    batten_body_edge edges[2];
    batten_body_use uses[2];
    batten_body *body = NULL;
    for (int k = 0; k < 2; k++) {
        make_border(face, k ? 0.4 : 1.5, &flat[k], &lifted[k]);
        must(batten_curve_evaluate(lifted[k], 0, 0, vertices[k]));
        edges[k] = (batten_body_edge){lifted[k], {k, k}};
        uses[k] = (batten_body_use){k, k == 1, flat[k]};
    }
    const batten_body_face whole = {.name = face->name, .surface = surface, .count = 2};
    const batten_body_parts parts = {.vertex_count = 2,
                                     .vertices = vertices[0],
                                     .edge_count = 2,
                                     .edges = edges,
                                     .use_count = 2,
                                     .uses = uses,
                                     .loop_count = 2,
                                     .loops = loops,
                                     .face_count = 1,
                                     .faces = &whole,
                                     .shell_count = 1,
                                     .shells = &shell,
                                     .tolerance = 1e-9,
                                     .is_traced = true};
    must(batten_body_create(&parts, &body));
    for (int k = 0; k < 2; k++) {
        batten_curve_unref(flat[k]);
        batten_curve_unref(lifted[k]);
    }
    batten_surface_unref(surface);
    return body;
}

int main(int count, char **arguments)
{
    size_t which = 0;
    if (count != 3) {
        for (size_t k = 0; k < KINDS; k++)
            puts(kinds[k].name);
        return 0;
    }
    while (which < KINDS && strcmp(kinds[which].name, arguments[1]) != 0)
        which++;
    if (which == KINDS)
        return 1;
    batten_mesh_options options = batten_mesh_defaults();
    options.chord = atof(arguments[2]);
    options.angle = 1;
    batten_body *body = make_body(&kinds[which]);
    batten_mesh_report report;
    batten_mesh *mesh = NULL;
    must(batten_mesh_from_body(body, &options, NULL, NULL, &report, &mesh));
    if (report.failed || report.beyond)
        return 1;
    printf("%d\n", batten_mesh_view(mesh)->triangle_count);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
    return 0;
}
