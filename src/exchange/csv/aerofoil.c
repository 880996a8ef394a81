/* Reads aerofoil sections: one list of points, or Lednicer's two halves with their counts. */
#include "exchange/csv/csv.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/*
 * A name, then "x y" in rows. In Selig's order they run from the trailing edge over the upper
 * side to the nose and back along the lower side. In Lednicer's, two counts come first, then
 * the upper and the lower side, each from the nose on. Either way the result runs as Selig's.
 */
typedef struct {
    bat_separated table;
    char *name;      /* "" when the file has none */
    bat_list points; /* of double[3] */
    int first_row;   /* line of the first point */
    size_t left_out; /* rows that are no points */
    char first_bad[700];
} reading;

/* Two fields of which the first is a number are a point, or mean to be one. */
static bool is_point(const bat_separated *table)
{
    return bat_row_length(table) == 2 && bat_field_is_number(table, 0);
}

static bat_span without_blanks(bat_span raw)
{
    size_t begin = 0, end = raw.length;
    while (begin < end && bat_is_blank(raw.bytes[begin]))
        begin++;
    while (end > begin && bat_is_blank(raw.bytes[end - 1]))
        end--;
    return (bat_span){raw.bytes + begin, end - begin};
}

static batten_status read_name(reading *r)
{
    const bat_span name = without_blanks(r->table.raw);
    batten_status status = bat_input_array(r->table.input, name.length + 1, 1, &r->name);
    if (status == BATTEN_OK)
        memcpy(r->name, name.bytes, name.length);
    return status;
}

static batten_status read_row(reading *r)
{
    double point[3] = {0, 0, 0};
    batten_status status = bat_row_check(&r->table, 2);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_field_number(&r->table, k, &point[k]);
    if (status == BATTEN_OK)
        status = bat_input_limit(r->table.input, r->table.line, r->points.count + 1,
                                 r->table.input->limits.points, "points");
    return status == BATTEN_OK ? bat_list_add(r->table.input, &r->points, point) : status;
}

/* A row that is no point, by the message at hand; the first one may yet be why the whole is
 * none. */
static batten_status leave_out(reading *r)
{
    bat_input *input = r->table.input;
    if (r->left_out == 0)
        snprintf(r->first_bad, sizeof r->first_bad, "%s", batten_message());
    r->left_out++;
    input->left_out++;
    batten_notes_add(input->notes, input->file, r->table.line, "",
                     "this row is not a point; it is left out");
    return BATTEN_OK;
}

/* More rows that are no points than points: no aerofoil with remarks, but another text. */
static batten_status refuse_prose(const reading *r)
{
    return r->left_out > r->points.count ? bat_fail(BATTEN_BAD_FORMAT, "%s", r->first_bad)
                                         : BATTEN_OK;
}

static batten_status read_rows(reading *r)
{
    bool more = false;
    batten_status status = bat_separated_next(&r->table, &more);
    if (status == BATTEN_OK && more && !is_point(&r->table)) {
        status = read_name(r);
        r->table.separator = 0;
        if (status == BATTEN_OK)
            status = bat_separated_next(&r->table, &more);
    }
    r->first_row = r->table.line;
    while (status == BATTEN_OK && more) {
        status = read_row(r);
        if (status != BATTEN_OK && !bat_input_ends(status))
            status = leave_out(r);
        if (status == BATTEN_OK)
            status = bat_separated_next(&r->table, &more);
    }
    return status == BATTEN_OK ? refuse_prose(r) : status;
}

/* ---- order ---- */

static bool is_count(double value)
{
    return value >= 2 && value <= 1e9 && floor(value) == value;
}

/* Lednicer's counts are whole numbers, and the nose comes next, far below them. */
bool bat_are_aerofoil_counts(const double first[3], const double second[3])
{
    return is_count(first[0]) && is_count(first[1]) && second[0] < first[0] / 2;
}

static void reverse(double (*points)[3], size_t count)
{
    for (size_t i = 0; i < count / 2; i++) {
        double kept[3];
        memcpy(kept, points[i], sizeof kept);
        memcpy(points[i], points[count - 1 - i], sizeof kept);
        memcpy(points[count - 1 - i], kept, sizeof kept);
    }
}

/* Drop the counts, turn the upper side round, and let the nose stand once. */
static batten_status order_lednicer(reading *r)
{
    double(*points)[3] = r->points.items;
    const double upper = points[0][0], lower = points[0][1];
    const size_t count = r->points.count - 1;
    if (upper + lower != (double)count)
        return bat_input_fail(r->table.input, BATTEN_BAD_FORMAT, r->first_row,
                              "%g and %g points are announced, but %zu follow", upper, lower,
                              count);
    const size_t side = (size_t)upper;
    memmove(points[0], points[1], count * sizeof *points);
    reverse(points, side);
    r->points.count = count;
    if (memcmp(points[side - 1], points[side], sizeof *points) == 0) {
        memmove(points[side], points[side + 1], (count - side - 1) * sizeof *points);
        r->points.count--;
    }
    return BATTEN_OK;
}

/* Twice the area within the points; positive when the upper side comes first. */
static double area(const double (*points)[3], size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        const double *p = points[i], *q = points[(i + 1) % count];
        sum += (p[0] - points[0][0]) * (q[1] - points[0][1]) -
               (q[0] - points[0][0]) * (p[1] - points[0][1]);
    }
    return sum;
}

/* Both ends must be at the trailing edge: nearer to it than a quarter of the chord. */
static batten_status check_ends(const reading *r)
{
    const double(*points)[3] = r->points.items;
    const size_t count = r->points.count;
    double low = points[0][0], high = low;
    for (size_t i = 0; i < count; i++) {
        low = bat_min(low, points[i][0]);
        high = bat_max(high, points[i][0]);
    }
    const double first = points[0][0], last = points[count - 1][0];
    const double least = low + 0.75 * (high - low);
    if (low < high && first >= least && last >= least)
        return BATTEN_OK;
    return bat_input_fail(r->table.input, BATTEN_BAD_FORMAT, r->table.line,
                          "the points begin at x = %g and end at x = %g, and not both at the "
                          "trailing edge, x = %g",
                          first, last, high);
}

/* Reverse the points where that makes the area positive: rounding may leave either order below
 * 0. */
static void put_upper_first(reading *r)
{
    double(*points)[3] = r->points.items;
    if (area((const double(*)[3])points, r->points.count) >= 0)
        return;
    reverse(points, r->points.count);
    if (area((const double(*)[3])points, r->points.count) > 0)
        batten_notes_add(r->table.input->notes, r->table.input->file, r->first_row, "",
                         "the lower side comes first; the order is reversed");
    else
        reverse(points, r->points.count);
}

static batten_status put_in_order(reading *r)
{
    double(*points)[3] = r->points.items;
    if (r->points.count < 3)
        return bat_input_fail(r->table.input, BATTEN_BAD_FORMAT, 0,
                              "an aerofoil needs at least 3 points, not %zu", r->points.count);
    batten_status status = BATTEN_OK;
    if (bat_are_aerofoil_counts(points[0], points[1]))
        status = order_lednicer(r);
    if (status == BATTEN_OK)
        status = check_ends(r);
    if (status == BATTEN_OK)
        put_upper_first(r);
    return status;
}

static batten_status make_model(const reading *r, batten_model **out)
{
    const batten_object object = {.name = r->name && r->name[0] ? r->name : "aerofoil",
                                  .kind = BATTEN_OBJECT_POINTS,
                                  .point_count = (int)r->points.count,
                                  .points = r->points.items};
    batten_model *model = NULL;
    batten_status status = batten_model_create(0, &model);
    if (status == BATTEN_OK)
        status = batten_model_add(model, &object);
    return bat_input_hand_over(status, model, out);
}

batten_status bat_read_aerofoil(bat_input *input, batten_model **out)
{
    reading r = {.points = {.size = 3 * sizeof(double)}};
    bat_separated_begin(&r.table, input);
    r.table.tabs_are_blanks = true;
    r.table.no_quotes = true;
    batten_status status = read_rows(&r);
    if (status == BATTEN_OK)
        status = put_in_order(&r);
    if (status == BATTEN_OK)
        status = make_model(&r, out);
    bat_separated_end(&r.table);
    bat_release(r.name);
    bat_release(r.points.items);
    return status;
}
