/* The feature 'corner-net': bicubic patches from points, tangents and twists at their
 * corners. */
#include "base/plural.h"
#include "design/shared/grid.h"

#include <batten/grid.h>
#include <string.h>

static const batten_parameter parameters[] = {
    {"corner-net", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, all of the same length: the corners of the faces"},
    {"tangents-u", BATTEN_VALUE_POINT, true, false, "origin", NULL,
     "derivatives along the rows, one for all corners or one for each, row by row"},
    {"tangents-v", BATTEN_VALUE_POINT, true, false, "origin", NULL,
     "derivatives across the rows"},
    {"twists", BATTEN_VALUE_POINT, true, false, NULL, NULL, "mixed second derivatives"},
    {"estimate", BATTEN_VALUE_WORD, false, false, "zero",
     "zero bilinear bessel adini spline energy", "where twists that are not given come from"},
};

/* The nodes of the net: points, Su, Sv, Suv, each [count_u][count_v][3], and parameters 0, 1 ..
 */
typedef struct {
    bat_grid grid;
    double *values; /* [4][count][3] */
    double *nodes;  /* [count][4][3] */
    double *at;     /* [the greater count] */
} net;

static void net_release(net *n)
{
    bat_grid_release(&n->grid);
    bat_release(n->values);
    bat_release(n->nodes);
    bat_release(n->at);
}

static batten_status net_begin(net *n)
{
    const int count = n->grid.count_u * n->grid.count_v;
    const int longest = bat_max_int(n->grid.count_u, n->grid.count_v);
    n->values = bat_array3((size_t)count, 12, sizeof *n->values);
    n->nodes = bat_array3((size_t)count, 12, sizeof *n->nodes);
    n->at = bat_array((size_t)longest, sizeof *n->at);
    if (!n->values || !n->nodes || !n->at)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(n->values, n->grid.points, 3 * (size_t)count * sizeof *n->values);
    for (int i = 0; i < longest; i++)
        n->at[i] = i;
    return BATTEN_OK;
}

/* Vectors as they are given, row by row, in the order of the net. */
static batten_status take_vectors(const bat_run *run, const char *parameter, net *n, int which)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    const int count_u = n->grid.count_u, count_v = n->grid.count_v, count = count_u * count_v;
    if (given->count != 1 && given->count != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has %d vector%s for %d corner%s", parameter,
                        given->count, bat_plural(given->count), count, bat_plural(count));
    double *out = n->values + (size_t)which * (size_t)count * 3;
    for (int i = 0; i < count_u; i++)
        for (int j = 0; j < count_v; j++)
            memcpy(out + 3 * (i * count_v + j),
                   given->items[given->count == 1 ? 0 : j * count_u + i].number,
                   3 * sizeof *out);
    return BATTEN_OK;
}

static batten_status make_corner_net(bat_run *run, net *n, batten_surface **out)
{
    batten_status status = bat_grid_of(run, "corner-net", &n->grid);
    if (status == BATTEN_OK)
        status = net_begin(n);
    if (status == BATTEN_OK)
        status = take_vectors(run, "tangents-u", n, 1);
    if (status == BATTEN_OK)
        status = take_vectors(run, "tangents-v", n, 2);
    if (status != BATTEN_OK)
        return status;
    const int count_u = n->grid.count_u, count_v = n->grid.count_v, count = count_u * count_v;
    const size_t step = 3 * (size_t)count;
    if (bat_has(run, "twists"))
        status = take_vectors(run, "twists", n, 3);
    else
        status = batten_net_twists((batten_twists)bat_word(run, "estimate"),
                                   &(batten_net){3, count_u, count_v, n->at, n->at, n->values,
                                                 n->values + step, n->values + 2 * step},
                                   NULL, NULL, n->values + 3 * step);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 4; k++)
            memcpy(n->nodes + 3 * (4 * i + k), n->values + (size_t)k * step + 3 * i,
                   3 * sizeof *n->nodes);
    return status == BATTEN_OK
               ? batten_surface_from_hermite((batten_uv){n->at, n->at},
                                             (batten_grid){3, count_u, count_v, n->nodes}, out)
               : status;
}

static batten_status run_corner_net(bat_run *run)
{
    net n = {0};
    batten_surface *surface = NULL;
    const batten_status status = make_corner_net(run, &n, &surface);
    net_release(&n);
    return bat_put_surface(run, status, surface);
}

const bat_feature bat_feature_corner_net = {
    .shown =
        {"corner-net", "Bicubic patches from points, tangents and twists at their corners",
         "Each face of the grid is a bicubic Coons patch over a unit square; neighbours have the\n"
         "same tangents, so the surface is smooth. The boundaries of the faces depend only on\n"
         "points and tangents; the twists change the inside.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]]\n"
         "    columns: 3\n"
         "  sheet: {corner-net: grid, tangents-u: [1, 0, 0.5], tangents-v: [0, 1, 0], twists: [0, 0, 1]}\n",
         "[SL section V.2] [Utah74 paper 13] [Coons67]", "batten_surface_from_hermite",
         BAT_PARAMETERS(parameters), false,
         .also =
             "bicubic patch, Ferguson patch, Hermite patch, twist vectors, parametric bicubic",
         .formula =
             "    S(u, v) = F(u) [r r_v; r_u r_uv] F(v)ᵀ,  F = (F0, F1, G0, G1) cubic, over each face",
         .promise =
             "Points, tangents and twists of the corners are met; neighbours join with one tangent plane."},
    .run = run_corner_net};
