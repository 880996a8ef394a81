/* Models in another unit: all lengths scaled, decimals kept short. */
#include "model/rebuild.h"
#include "model/short_decimal.h"

#include <batten/text.h>
#include <stdio.h>
#include <string.h>

/* ---- tables of offsets ---- */

enum { NAME = BATTEN_NUMBER_SIZE + 8 };

/* A table on its way to another unit. */
typedef struct {
    const batten_offset_table *from;
    double factor;
    batten_table_line *lines;
    batten_table_station *stations;
    batten_table_point *points;
    char (*names)[NAME]; /* of stations, then of lines, where they are made of numbers */
} unit_table;

static double scaled(double value, double factor, bool to_decimal)
{
    return to_decimal ? bat_near_decimal(value * factor) : value * factor;
}

/* A name that says the old number says the new one; others stay. */
static const char *new_name(const char *name, const char *begin, double old, double new,
                            char made[NAME])
{
    char number[BATTEN_NUMBER_SIZE];
    batten_number_write(old + 0.0, number);
    snprintf(made, NAME, "%s%s", begin, number);
    if (strcmp(name, made) != 0)
        return name;
    batten_number_write(new + 0.0, number);
    snprintf(made, NAME, "%s%s", begin, number);
    return made;
}

static void scale_lines(unit_table *t, bool to_decimal)
{
    char(*names)[NAME] = t->names + batten_offset_table_station_count(t->from);
    for (int i = 0; i < batten_offset_table_line_count(t->from); i++) {
        batten_table_line line = *batten_offset_table_line(t->from, i);
        const double old = line.z;
        line.z = scaled(old, t->factor, to_decimal);
        if (line.is_waterline)
            line.name = new_name(line.name, "z=", old, line.z, names[i]);
        t->lines[i] = line;
    }
}

/* Are the stations still in order? */
static bool scale_stations(unit_table *t, bool to_decimal)
{
    bool rises = true;
    for (int i = 0, used = 0; i < batten_offset_table_station_count(t->from); i++) {
        batten_table_station station = *batten_offset_table_station(t->from, i);
        const double old = station.x;
        station.x = scaled(old, t->factor, to_decimal);
        station.name = new_name(station.name, "", old, station.x, t->names[i]);
        for (int k = 0; k < station.point_count; k++) {
            batten_table_point p = station.points[k];
            p.x = scaled(p.x, t->factor, to_decimal);
            p.y = scaled(p.y, t->factor, to_decimal);
            p.z = scaled(p.z, t->factor, to_decimal);
            t->points[used + k] = p;
        }
        station.points = t->points + used;
        used += station.point_count;
        t->stations[i] = station;
        rises &= i == 0 || station.x > t->stations[i - 1].x;
    }
    return rises;
}

/* Numbers go to short decimals beside them: 24 in are 609.6 mm, not 609.5999999999999. */
static batten_status scale_offsets(const batten_offset_table *offsets, double factor,
                                   double unit_metres, batten_offset_table **out)
{
    const double own = batten_offset_table_unit_metres(offsets);
    const size_t stations = (size_t)batten_offset_table_station_count(offsets);
    const size_t lines = (size_t)batten_offset_table_line_count(offsets);
    size_t points = 0;
    for (size_t i = 0; i < stations; i++)
        points += (size_t)batten_offset_table_station(offsets, (int)i)->point_count;
    unit_table t = {.from = offsets,
                    .factor = bat_near_decimal(own > 0 ? own / unit_metres : factor),
                    .lines = bat_array(lines + 1, sizeof *t.lines),
                    .stations = bat_array(stations, sizeof *t.stations),
                    .points = bat_array(points, sizeof *t.points),
                    .names = bat_array(stations + lines, sizeof *t.names)};
    batten_status status =
        t.lines && t.stations && t.points && t.names ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const bool to_decimal = t.factor != 1 && scale_stations(&t, true);
        if (!to_decimal)
            (void)scale_stations(&t, false);
        scale_lines(&t, to_decimal);
        status = batten_offset_table_create(unit_metres, (int)lines, t.lines, (int)stations,
                                            t.stations, out);
    }
    bat_release(t.lines);
    bat_release(t.stations);
    bat_release(t.points);
    bat_release(t.names);
    return status;
}

/* ---- the whole ---- */

static batten_status add_scaled(void *context, const batten_model *from, int index,
                                batten_model *model, const batten_object *object)
{
    (void)from;
    (void)index;
    const double factor = *(const double *)context;
    const batten_affine map = batten_affine_scaling(factor, factor, factor);
    if (object->kind != BATTEN_OBJECT_OFFSET_TABLE)
        return factor == 1 || object->kind == BATTEN_OBJECT_INSTANCE
                   ? batten_model_add(model, object)
                   : batten_model_add_mapped(model, object, &map);
    batten_object scaled = *object;
    batten_offset_table *offsets = NULL;
    batten_status status =
        scale_offsets(object->offset_table, factor, batten_model_unit_metres(model), &offsets);
    scaled.offset_table = offsets;
    if (status == BATTEN_OK)
        status = batten_model_add(model, &scaled);
    batten_offset_table_unref(offsets);
    return status;
}

batten_status batten_model_to_unit(const batten_model *model, double unit_metres,
                                   batten_model **out)
{
    if (!isfinite(unit_metres) || unit_metres <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a unit of %g metres is not allowed", unit_metres);
    const double own = batten_model_unit_metres(model);
    double factor = own > 0 ? own / unit_metres : 1;
    return bat_model_change(model, unit_metres, factor, add_scaled, &factor, out);
}
