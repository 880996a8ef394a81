/* Surfaces whose points others have published: NURBS-Python, GoTools. */
#include <batten/surface.h>

#include "support/json.h"
#include "support/test.h"

static void check_row(const batten_surface *surface, const double *uv, int k, int l,
                      const double *expected, double tolerance)
{
    double out[6 * 3];
    CHECK_OK(batten_surface_evaluate(surface, uv[0], uv[1], k + l, out));
    for (int x = 0; x < 3; x++)
        CHECK_NEAR(out[BATTEN_SURFACE_DERIVATIVE(k, l) * 3 + x], expected[x], tolerance);
}

/* ---- NURBS-Python: three decimals ---- */

static batten_surface *geomdl_surface(const char *module, const char *name)
{
    const char *object = json_key(json_key(module, "objects"), name);
    double P[256], w[64], U[32], V[32];
    const int n = json_numbers(json_key(object, "ctrlpts"), 256, P) / 3;
    const char *weights = json_try(object, "weights");
    if (weights)
        CHECK_INT(json_numbers(weights, 64, w), n);
    json_numbers(json_key(object, "knotvector_u"), 32, U);
    json_numbers(json_key(object, "knotvector_v"), 32, V);
    const batten_axis u = {(int)json_number(json_key(object, "degree_u")),
                           (int)json_number(json_key(object, "ctrlpts_size_u")), U, false},
                      v = {(int)json_number(json_key(object, "degree_v")),
                           (int)json_number(json_key(object, "ctrlpts_size_v")), V, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, P, weights ? w : NULL, &surface));
    return surface;
}

TEST(points_of_nurbs_pythons_surfaces_are_reproduced)
{
    static const char *const pairs[][2] = {{"spline_surf", "test_bspline_surface_eval"},
                                           {"nurbs_surf", "test_nurbs_surface_eval"}};
    const char *module = json_key(json_file("peer_tests/geomdl_cases.json"), "test_surface");
    for (int c = 0; c < COUNT(pairs); c++) {
        batten_surface *surface = geomdl_surface(module, pairs[c][0]);
        const char *rows = json_key(json_key(json_key(module, "cases"), pairs[c][1]), "rows");
        int i = 0;
        for (double row[5]; json_item(rows, i); i++) {
            CHECK_INT(json_numbers(json_item(rows, i), 5, row), 5);
            check_row(surface, row, 0, 0, row + 2, 1e-3);
        }
        CHECK(i >= 10);
        batten_surface_unref(surface);
    }
}

TEST(knots_of_nurbs_pythons_surface_are_inserted_and_removed)
{
    const char *module = json_key(json_file("peer_tests/geomdl_cases.json"), "test_surface");
    batten_surface *surface = geomdl_surface(module, "spline_surf"), *more = NULL,
                   *again = NULL;
    const double at[2] = {0.3, 0.4}, published[3] = {-7.006, -3.308, -6.265};
    for (int k = 0; k < 2; k++) {
        int removed = 0;
        double error = 1;
        CHECK_OK(batten_surface_insert_knot(surface, (batten_direction)k, 0.3, 2, &more));
        check_row(more, at, 0, 0, published, 0.6e-3);
        CHECK_NEAR(batten_surface_knots(more, (batten_direction)k)[4], 0.3, 0);
        CHECK_NEAR(batten_surface_knots(more, (batten_direction)k)[6], 0.33, 0);
        CHECK_OK(batten_surface_remove_knot(more,
                                            (batten_knot_line){(batten_direction)k, 0.3, 2},
                                            1e-12, &removed, &error, &again));
        CHECK_INT(removed, 2);
        CHECK_INT(batten_surface_point_count(again, (batten_direction)k), 6);
        batten_surface_unref(more);
        batten_surface_unref(again);
    }
    batten_surface_unref(surface);
}

/* ---- GoTools: all digits ---- */

/* The numbers at the beginning of a file. */
static int g2_numbers(const char *name, int most, double *out)
{
    char path[128];
    snprintf(path, sizeof path, "g2/%s", name);
    const char *at = json_file(path);
    int count = 0;
    for (char *end; count < most; at = end) {
        const double number = strtod(at, &end);
        if (end == at)
            break;
        out[count++] = number;
    }
    return count;
}

/* A tensor surface, u fastest; of a rational one the points are weighted. */
static batten_surface *g2_surface(const char *name)
{
    enum { MOST = 20000 };
    double *numbers = test_array(MOST, sizeof *numbers),
           *points = test_array(MOST, sizeof *points),
           *weights = test_array(MOST, sizeof *weights);
    const int count = g2_numbers(name, MOST, numbers);
    const double *at = numbers + 4 + (int)numbers[3]; /* behind header and colour */
    CHECK_INT((int)numbers[0], 200);
    const int d = (int)at[0], rational = (int)at[1];
    const int nu = (int)at[2], pu = (int)at[3] - 1;
    const double *U = at + 4, *second = U + nu + pu + 1;
    const int nv = (int)second[0], pv = (int)second[1] - 1;
    const double *V = second + 2, *net = V + nv + pv + 1;
    CHECK_INT(d, 3);
    CHECK(net + nu * nv * (d + rational) <= numbers + count);
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++) {
            const double *from = net + (j * nu + i) * (d + rational);
            const double w = rational ? from[d] : 1;
            weights[i * nv + j] = w;
            for (int x = 0; x < d; x++)
                points[(i * nv + j) * d + x] = from[x] / w;
        }
    const batten_axis u = {pu, nu, U, false}, v = {pv, nv, V, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(d, &u, &v, points, rational ? weights : NULL, &surface));
    return surface;
}

TEST(points_and_derivatives_of_gotools_surfaces_are_reproduced)
{
    static const char *const names[] = {
        "bilinear.g2", "cone_sf.g2",     "degenerate_sf.g2",    "degenerate_triangle.g2",
        "octant.g2",   "spline_sfs1.g2", "spline_surface_1.g2", "squarecubic.g2",
        "surface.g2",  "test_bezier.g2"};
    const char *all = json_file("peer_tests/g2_evaluation.json");
    for (int n = 0; n < COUNT(names); n++) {
        batten_surface *surface = g2_surface(names[n]);
        const char *object = json_item(json_key(json_key(all, names[n]), "objects"), 0);
        const char *samples = json_key(object, "samples");
        const batten_box box = batten_surface_box(surface);
        const double size = hypot(hypot(box.high.x - box.low.x, box.high.y - box.low.y),
                                  box.high.z - box.low.z);
        for (int i = 0; json_item(samples, i); i++) {
            const char *sample = json_item(samples, i);
            double uv[2], p[3], du[3], dv[3];
            uv[0] = json_number(json_key(sample, "u"));
            uv[1] = json_number(json_key(sample, "v"));
            json_numbers(json_key(sample, "p"), 3, p);
            json_numbers(json_key(sample, "du"), 3, du);
            json_numbers(json_key(sample, "dv"), 3, dv);
            check_row(surface, uv, 0, 0, p, 1e-12 * size);
            check_row(surface, uv, 1, 0, du, 1e-10 * size);
            check_row(surface, uv, 0, 1, dv, 1e-10 * size);
        }
        batten_surface_unref(surface);
    }
}

/* ---- Newell's teapot ---- */

/* Patches of 16 points of a file of numbered vertices. */
static int newell_patches(const char *path, double (*patches)[16][3], int most)
{
    static const char blanks[] = ", \n\r\t";
    const char *at = json_file(path);
    int *corners = test_array((size_t)most * 16, sizeof *corners);
    double *vertices = test_array(3 * 512, sizeof *vertices);
    char *end;
    const int count = (int)strtol(at, &end, 10);
    CHECK(count > 0 && count <= most);
    for (int i = 0; i < 16 * count; i++)
        corners[i] = (int)strtol(end + strspn(end, blanks), &end, 10);
    const int vertex_count = (int)strtol(end + strspn(end, blanks), &end, 10);
    CHECK(vertex_count <= 512);
    for (int i = 0; i < 3 * vertex_count; i++)
        vertices[i] = strtod(end + strspn(end, blanks), &end);
    for (int i = 0; i < 16 * count; i++) {
        CHECK(corners[i] >= 1 && corners[i] <= vertex_count);
        memcpy(patches[i / 16][i % 16], vertices + 3 * (corners[i] - 1), 3 * sizeof *vertices);
    }
    return count;
}

/* The volume below a patch and above its shadow, exactly: of x Nx, by Gauss' points. */
static double volume_under(const batten_surface *patch)
{
    static const double at[5] = {0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
                                 0.953089922969332};
    static const double weight[5] = {0.118463442528095, 0.239314335249683, 0.284444444444444,
                                     0.239314335249683, 0.118463442528095};
    double sum = 0;
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            double s[9];
            CHECK_OK(batten_surface_evaluate(patch, at[i], at[j], 1, s));
            sum += weight[i] * weight[j] * s[2] * (s[3] * s[7] - s[4] * s[6]);
        }
    return sum;
}

/* The body of the pot is made of quarters that are mirror images of each other. */
TEST(the_quarters_of_the_teapots_body_hold_equal_volumes)
{
    static const double unit[2] = {0, 1};
    double(*patches)[16][3] = test_array(40, sizeof *patches);
    const int count = newell_patches("patches/newell_teapot.txt", patches, 40);
    CHECK_INT(count, 32);
    for (int ring = 0; ring < 3; ring++) { /* rim, upper and lower body: four patches each */
        double volumes[4];
        for (int i = 0; i < 4; i++) {
            batten_surface *patch = NULL;
            CHECK_OK(batten_surface_from_bezier(3, (batten_pieces){3, 1, unit},
                                                (batten_pieces){3, 1, unit},
                                                &patches[4 * ring + i][0][0], NULL, &patch));
            volumes[i] = fabs(volume_under(patch));
            batten_surface_unref(patch);
        }
        for (int i = 1; i < 4; i++)
            CHECK_NEAR(volumes[i], volumes[0], 1e-12 * (1 + volumes[0]));
    }
}
