/* How high the edge of the deck stands above the water: pieces of Bezier curves are halved while they may be lower
 * than what is known (branch and bound). */
#include "hydrostatics/wet.h"
#include "numeric/bernstein.h"
#include <batten/measure.h>

/* As a part of the size. */
static const double NEAR = 1e-12;
enum { MOST_DEPTH = 60 };

/* Heights times weights, and weights, of a row or a part of it. */
typedef struct {
    int degree;
    double heights[BATTEN_MAX_DEGREE + 1], weights[BATTEN_MAX_DEGREE + 1];
} piece;

typedef struct {
    double height, at[3]; /* of the lowest point, in the coordinates of the patches */
} lowest;

/* Edges along the ship, above the middle of the hull. */
static bool is_deck(const batten_hull *hull, int lid)
{
    if (lid < 0)
        return false;
    const batten_box *edge = &hull->lids[lid].edge;
    return edge->high.x - edge->low.x > edge->high.z - edge->low.z &&
           edge->low.z > 0.5 * (hull->box.low.z + hull->box.high.z);
}

/* Between its control points a rational curve of positive weights is nowhere lower than they are. */
static bool may_be_lower(const piece *p, double than)
{
    for (int k = 0; k <= p->degree; k++)
        if (p->heights[k] < (than - NEAR) * p->weights[k])
            return true;
    return false;
}

static void look_at_ends(const piece *p, const bat_row *row, batten_interval part, lowest *out)
{
    for (int end = 0; end < 2; end++) {
        const int k = end * p->degree;
        const double height = p->heights[k] / p->weights[k];
        bat_row_point point;
        if (!(height < out->height))
            continue;
        bat_row_at(row, end == 0 ? part.a : part.b, &point);
        *out = (lowest){height, {point.at[0], point.at[1], point.at[2]}};
    }
}

/* The part of a row. */
static void take_part(const piece *row, batten_interval part, piece *out)
{
    const int n = row->degree;
    const double cut = (part.b - part.a) / (1 - part.a);
    out->degree = n;
    bat_bernstein_split(n, row->heights, part.a, NULL, out->heights);
    bat_bernstein_split(n, row->weights, part.a, NULL, out->weights);
    bat_bernstein_split(n, out->heights, cut, out->heights, NULL);
    bat_bernstein_split(n, out->weights, cut, out->weights, NULL);
}

static void search_row(const bat_row *row, const bat_water *water, lowest *out)
{
    batten_interval waiting[MOST_DEPTH + 1] = {{0, 1}};
    int count = 1;
    piece whole = {.degree = row->degree}, part;
    bat_row_heights(row, water->n, water->d, whole.heights);
    for (int k = 0; k <= row->degree; k++)
        whole.weights[k] = row->at[k][3];
    while (count > 0) {
        batten_interval *w = &waiting[count - 1];
        const double middle = 0.5 * (w->a + w->b);
        take_part(&whole, *w, &part);
        look_at_ends(&part, row, *w, out);
        if (count <= MOST_DEPTH && may_be_lower(&part, out->height)) {
            waiting[count++] = (batten_interval){middle, w->b};
            w->b = middle;
        } else {
            count--;
        }
    }
}

batten_status batten_hull_freeboard(const batten_hull *hull, const batten_flotation *flotation,
                                    double *freeboard, batten_vec3 *at)
{
    bat_water water;
    lowest found = {INFINITY, {0}};
    const batten_status status = bat_water_of(hull, flotation, &water);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < hull->patch_count; i++)
        for (int side = 0; side < 2 && is_deck(hull, hull->patches[i].lid); side++) {
            bat_row row;
            const bat_patch *patch = &hull->patches[i];
            bat_patch_row(patch, hull->lids[patch->lid].direction, side, &row);
            search_row(&row, &water, &found);
        }
    if (!isfinite(found.height))
        return bat_fail(BATTEN_NOT_FOUND,
                        "no edge of a deck is known: nothing along the ship in the upper half "
                        "of the hull was closed across");
    *freeboard = hull->size * found.height;
    if (at)
        *at = (batten_vec3){hull->centre[0] + hull->size * found.at[0],
                            hull->centre[1] + hull->size * found.at[1],
                            hull->centre[2] + hull->size * found.at[2]};
    return BATTEN_OK;
}
