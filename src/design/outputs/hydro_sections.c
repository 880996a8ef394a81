/* Areas of cross sections in the report of hydrostatics, and the largest of them. */
#include "design/outputs/hydrostatics.h"

/* Of areas, and of the place of the largest, as parts of the hull: there areas change with the square of the place. */
static const double PRECISION = 1e-8, NEAR = 1e-4;
/* What golden sections leave of an interval. */
static const double GOLDEN = 0.61803398874989485;

double bat_hydro_place(const batten_hull *hull, int index)
{
    const batten_box box = batten_hull_box(hull);
    const double share = (double)index / (BAT_HYDRO_PLACES - 1);
    return box.low.x + share * (box.high.x - box.low.x);
}

/* Less than the precision is nothing; what is not found within it, as where a section touches a surface along
 * a curve, is NAN and counted. */
static batten_status area_at(const bat_hydro_water *w, double x, double *area)
{
    const batten_box box = batten_hull_box(w->hull);
    const double rectangle = (box.high.y - box.low.y) * (box.high.z - box.low.z);
    const batten_status status =
        batten_hull_section_area(w->hull, &w->at, x, PRECISION, w->job, area);
    if (status == BATTEN_TOLERANCE_NOT_MET) {
        *area = (double)NAN;
        ++*w->lost;
        return BATTEN_OK;
    }
    if (status == BATTEN_OK && *area < PRECISION * rectangle)
        *area = 0;
    return status;
}

static batten_status areas_at(const bat_hydro_water *w, int count, const double *places,
                              double *areas)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        status = area_at(w, places[i], &areas[i]);
    return status;
}

/* The largest area between two places, by golden sections; never less than `*largest`. */
static batten_status climb(const bat_hydro_water *w, batten_interval between, double *largest)
{
    const batten_box box = batten_hull_box(w->hull);
    const double near = NEAR * (box.high.x - box.low.x);
    double x[2] = {between.b - GOLDEN * (between.b - between.a),
                   between.a + GOLDEN * (between.b - between.a)};
    double areas[2];
    batten_status status = areas_at(w, 2, x, areas);
    while (status == BATTEN_OK && between.b - between.a > near) {
        const int worse = !(areas[0] >= areas[1]) ? 0 : 1;
        *(worse == 0 ? &between.a : &between.b) = x[worse];
        areas[worse] = areas[!worse];
        x[worse] = x[!worse];
        x[!worse] = worse == 0 ? between.a + GOLDEN * (between.b - between.a)
                               : between.b - GOLDEN * (between.b - between.a);
        status = area_at(w, x[!worse], &areas[!worse]);
    }
    for (int k = 0; k < 2; k++)
        *largest = areas[k] > *largest ? areas[k] : *largest;
    return status;
}

/* Next to the best of many places; `known` are the areas there, or NULL. */
static batten_status find_largest(const bat_hydro_water *w, const double *known,
                                  double *largest)
{
    double places[BAT_HYDRO_PLACES], areas[BAT_HYDRO_PLACES];
    int best = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < BAT_HYDRO_PLACES; i++)
        places[i] = bat_hydro_place(w->hull, i);
    if (!known)
        status = areas_at(w, BAT_HYDRO_PLACES, places, areas);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < BAT_HYDRO_PLACES; i++) {
        areas[i] = known ? known[i] : areas[i];
        best = areas[i] > areas[best] || isnan(areas[best]) ? i : best;
    }
    *largest = isnan(areas[best]) ? 0 : areas[best];
    return climb(w,
                 (batten_interval){places[bat_max_int(0, best - 1)],
                                   places[bat_min_int(BAT_HYDRO_PLACES - 1, best + 1)]},
                 largest);
}

/* Are these the places among which the largest is sought? */
static bool are_own(const bat_hydro_water *w, int count, const double *places)
{
    for (int i = 0; i < count && count == BAT_HYDRO_PLACES; i++)
        if (places[i] != bat_hydro_place(w->hull, i))
            return false;
    return count == BAT_HYDRO_PLACES;
}

batten_status bat_hydro_fill_sections(const bat_hydro_water *w, int count, const double *places,
                                      double *areas, double values[BAT_HYDRO_COLUMNS])
{
    double largest = 0;
    batten_status status = areas_at(w, count, places, areas);
    if (status == BATTEN_OK)
        status = find_largest(w, are_own(w, count, places) ? areas : NULL, &largest);
    const double around = w->breadth * values[BAT_HYDRO_T];
    const double prism = w->length * largest;
    values[BAT_HYDRO_AX] = largest;
    values[BAT_HYDRO_CX] = around > 0 ? largest / around : (double)NAN;
    values[BAT_HYDRO_CP] = prism > 0 ? values[BAT_HYDRO_VOLUME] / prism : (double)NAN;
    return status;
}
