/* The feature 'bezier-triangle': Bezier triangles from their control nets. */
#include "base/plural.h"
#include "design/feature.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"bezier-triangle", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the net: points in rows away from the first corner, 1, 2, 3 ... in a row"},
    {"degree", BATTEN_VALUE_COUNT, false, false, NULL, NULL,
     "with it the points may be the nets of several triangles; without it they are one net"},
    {"weights", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "of all points: rational triangles"},
    {"halve", BATTEN_VALUE_COUNT, false, false, "0", NULL,
     "cut every triangle into four, this many times"},
};

/* All points of the principal input, one object after the other. */
static batten_status gather_points(const bat_run *run, int *count, double **out)
{
    bat_objects objects;
    batten_status status = bat_gather(run, "bezier-triangle", BAT_POINTS, &objects);
    if (status != BATTEN_OK)
        return status;
    size_t total = 0;
    for (int i = 0; i < objects.count; i++)
        total += (size_t)objects.at[i]->point_count;
    double *points = bat_array3(total, 3, sizeof *points), *to = points;
    for (int i = 0; points && i < objects.count; i++) {
        const size_t numbers = 3 * (size_t)objects.at[i]->point_count;
        memcpy(to, objects.at[i]->points, numbers * sizeof *to);
        to += numbers;
    }
    bat_objects_release(&objects);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    *out = points;
    *count = (int)total;
    return BATTEN_OK;
}

/* The degree that is given, or that of the one net that the points are. */
static batten_status find_degree(const bat_run *run, int count, int *degree)
{
    int n = bat_has(run, "degree") ? bat_count(run, "degree") : 1;
    while (!bat_has(run, "degree") && n < BATTEN_MAX_DEGREE &&
           BATTEN_TRIANGLE_POINTS(n) < count)
        n++;
    if (n < 1 || n > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", n,
                        BATTEN_MAX_DEGREE);
    const int each = BATTEN_TRIANGLE_POINTS(n);
    if (bat_has(run, "degree") && (count < each || count % each))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d points do not make whole nets of degree %d, which have %d each",
                        count, n, each);
    if (count != each && !bat_has(run, "degree"))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d point%s %s not make a triangular net, which has 3, 6, 10, 15 ...; "
                        "'degree' cuts a list into several nets",
                        count, bat_plural(count), bat_one_or_many(count, "does", "do"));
    *degree = n;
    return BATTEN_OK;
}

static batten_status read_weights(const bat_run *run, int count, double **out)
{
    const bat_argument *given = bat_argument_of(run, "weights");
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d weight%s for %d point%s", given->count,
                        bat_plural(given->count), count, bat_plural(count));
    double *weights = bat_array((size_t)count, sizeof *weights);
    if (!weights)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        weights[i] = given->items[i].number[0];
    *out = weights;
    return BATTEN_OK;
}

static batten_status halve(const bat_run *run, batten_triangles **triangles)
{
    for (int i = 0; i < bat_count(run, "halve"); i++) {
        batten_triangles *finer = NULL;
        const batten_status status = batten_triangles_halve(*triangles, &finer);
        if (status != BATTEN_OK)
            return status;
        batten_triangles_unref(*triangles);
        *triangles = finer;
    }
    return BATTEN_OK;
}

static batten_status run_bezier_triangle(bat_run *run)
{
    int count = 0, degree = 0;
    double *points = NULL, *weights = NULL;
    batten_triangles *triangles = NULL;
    batten_status status = gather_points(run, &count, &points);
    if (status == BATTEN_OK)
        status = find_degree(run, count, &degree);
    if (status == BATTEN_OK)
        status = read_weights(run, count, &weights);
    if (status == BATTEN_OK)
        status = batten_triangles_create(
            &(batten_triangles_parts){3, degree, count / BATTEN_TRIANGLE_POINTS(degree), points,
                                      weights, NULL},
            &triangles);
    if (status == BATTEN_OK)
        status = halve(run, &triangles);
    bat_release(points);
    bat_release(weights);
    return bat_put_triangles(run, status, triangles);
}

const bat_feature bat_feature_bezier_triangle = {
    .shown =
        {"bezier-triangle", "Bezier triangles from their control nets",
         "A net of degree n has n + 1 points on every side and (n + 1)(n + 2) / 2 in all: the\n"
         "first corner, then row after row, the last of which is the side from the second corner\n"
         "to the third. The surface goes through the corners, its edges have the sides of the net\n"
         "as control polygons, and it lies within the convex hull of its net. 'write' puts every\n"
         "triangle into files as three exact NURBS patches; 'check' measures gaps and angles\n"
         "between triangles.",
         "features:\n"
         "  net: {points: [[0, 0, 0], [1, 0, 1], [0, 1, 1], [2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n"
         "  sail: {bezier-triangle: net}\n",
         "[Farin86], [Hu96]", "batten_triangles_create", BAT_PARAMETERS(parameters), false,
         .also = "Bernstein-Bézier triangle, triangular patch",
         .formula = "    b(b1, b2, b3) = Σ n!/(i! j! k!) b1^i b2^j b3^k c_ijk,  i + j + k = n",
         .promise = "The surface lies in the convex hull of its net."},
    .run = run_bezier_triangle};
