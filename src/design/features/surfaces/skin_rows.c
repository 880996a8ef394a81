/* The feature 'skin-rows': the surface through rows of points. */
#include "base/plural.h"
#include "design/shared/folds.h"
#include "design/shared/place.h"
#include "design/shared/rows.h"
#include <batten/skin.h>

#include <string.h>

static const batten_parameter parameters[] = {
    {"skin-rows", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, in order; of a table of offsets its stations"},
    {"degree-u", BATTEN_VALUE_COUNT, false, false, "3", NULL, "along the rows"},
    {"degree-v", BATTEN_VALUE_COUNT, false, false, "3", NULL, "across the rows"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to the points"},
    {"across", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to the rows"},
    {"margin", BATTEN_VALUE_NUMBER, false, false, "0.25", NULL,
     "how far knots keep from the ends of their admissible intervals, as a share"},
    {"ends", BATTEN_VALUE_WORD, false, false, "not-a-knot", BAT_END_WORDS,
     "what holds at both ends"},
    {"start", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS,
     "what holds at the first row"},
    {"start-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative or direction there"},
    {"end", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS, "what holds at the last row"},
    {"end-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative or direction there"},
    {"periodic", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
};

/* All rows one after another. */
typedef struct {
    int count, capacity;
    size_t used, room;
    int *counts;    /* [capacity] */
    double *points; /* [room][3] */
} all_rows;

static void measure_skin_rows(const bat_rows *rows, all_rows *all)
{
    all->capacity += rows->count;
    for (int i = 0; i < rows->count; i++)
        all->room += (size_t)rows->rows[i].count;
}

static void take_rows(const bat_run *run, const bat_rows *rows, all_rows *all)
{
    for (int i = 0; i < rows->count; i++) {
        const bat_row *row = &rows->rows[i];
        bat_note_spacing(run, row->name, row->count, row->points);
        memcpy(all->points + 3 * all->used, row->points,
               3 * (size_t)row->count * sizeof *row->points);
        all->used += (size_t)row->count;
        all->counts[all->count++] = row->count;
    }
}

static batten_status gather(const bat_run *run, const bat_objects *objects, all_rows *all)
{
    bat_rows *rows = bat_array((size_t)objects->count, sizeof *rows);
    batten_status status = rows ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < objects->count; i++) {
        status = bat_rows_of(objects->at[i], false, &rows[i]);
        if (status == BATTEN_OK)
            measure_skin_rows(&rows[i], all);
    }
    if (status == BATTEN_OK) {
        all->counts = bat_array((size_t)all->capacity, sizeof *all->counts);
        all->points = bat_array3(all->room, 3, sizeof *all->points);
        status = all->counts && all->points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    for (int i = 0; rows && i < objects->count; i++) {
        if (status == BATTEN_OK)
            take_rows(run, &rows[i], all);
        bat_rows_release(&rows[i]);
    }
    bat_release(rows);
    return status;
}

static batten_status skin(bat_run *run, const all_rows *all)
{
    batten_surface_skin_options across = batten_surface_skin_defaults();
    across.degree = bat_count(run, "degree-v");
    across.parameters = (batten_parametrization)bat_word(run, "across");
    across.start = bat_end(run, "start", "start-vector");
    across.end = bat_end(run, "end", "end-vector");
    across.closed = bat_yes(run, "periodic");
    batten_surface_skin_rows_options options = batten_surface_skin_rows_defaults();
    options.degree = bat_count(run, "degree-u");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.margin = bat_number(run, "margin");
    options.across = &across;
    batten_surface_skin_rows_report report;
    batten_surface *surface = NULL;
    batten_status status = batten_surface_skin_rows(
        (batten_rows){3, all->count, all->counts, all->points}, &options, run->job,
        (batten_uv_out){NULL, NULL}, &report, &surface);
    if (status == BATTEN_OK) {
        bat_remark(run,
                   "%d inner knot%s along the rows, where knots of their own would be %d; %d "
                   "row%s with fewer points than control points",
                   report.knot_count, bat_plural(report.knot_count), report.separate_knot_count,
                   report.free_rows, bat_plural(report.free_rows));
        bat_report_error(run, report.error, report.error);
    }
    if (status == BATTEN_OK)
        status =
            bat_note_slivers(run, surface, "a smaller 'margin' lets rows share more knots");
    return bat_put_surface(run, status, surface);
}

static batten_status run_skin_rows(bat_run *run)
{
    bat_objects objects;
    batten_status status = bat_gather(run, "skin-rows", BAT_POINTS | BAT_OFFSETS, &objects);
    if (status != BATTEN_OK)
        return status;
    all_rows all = {0};
    status = gather(run, &objects, &all);
    if (status == BATTEN_OK)
        status = skin(run, &all);
    bat_release(all.points);
    bat_release(all.counts);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_skin_rows = {
    .shown =
        {"skin-rows", "The surface through rows of points",
         "Each row may have as many points as it needs; u runs along the rows, v across them. Rows\n"
         "share knots wherever each of them can be interpolated with them, so that few are needed;\n"
         "what the points of a row leave open has the least energy.",
         "features:\n"
         "  a: {points: [[0, 0, 0], [0, 1, 0.3], [0, 2, 0.2], [0, 3, 0]]}\n"
         "  b: {points: [[1, 0, 0.2], [1, 0.7, 0.6], [1, 1.4, 0.7], [1, 2.2, 0.4], [1, 3, 0]]}\n"
         "  c: {points: [[2, 0, 0], [2, 1.5, 0.4], [2, 3, 0.1]]}\n"
         "  roof: {skin-rows: [a, b, c]}\n",
         "[PT00]", "batten_surface_skin_rows", BAT_PARAMETERS(parameters), false,
         .also = "lofting of rows, uneven rows, contours",
         .formula =
             "    S(u, v) = Σ Σ d_ij N_i(u) N_j(v),  S(u_qr, v_q) = p_qr for the points r of each row q",
         .promise =
             "Every point is met; what is left open has the least ∫ |S″|² along its row."},
    .run = run_skin_rows};
