/* A .ftm file of FREE!ship: control points, edges, curves and faces. */
#include "base/plural.h"
#include "exchange/ftm/reading.h"
#include "exchange/meshes/facets.h"
#include "exchange/reading/scan.h"

#include <batten/text.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

batten_status bat_ftm_recognise(const bat_input *input, bool *is_ftm)
{
    *is_ftm = bat_begins(input, 0, "FREE!ship\n") || bat_begins(input, 0, "FREE!ship\r\n");
    return BATTEN_OK;
}

/* Settings of many kinds stand before the net; it begins where a number of points is followed
 * by as many of them: three coordinates and three marks each. */
static batten_status find_points(bat_ftm_reading *r)
{
    double xyz[3];
    int count = 0, mark = 0;
    for (size_t i = 0; i + BAT_FTM_LINES_OF_POINT < r->lines.count; i++) {
        if (bat_ftm_numbers_of(bat_ftm_line_of(r, i + 1), 3, xyz) != 3 ||
            !bat_ftm_is_whole(r, i, &count) || count < 3 ||
            (size_t)count > (r->lines.count - i) / BAT_FTM_LINES_OF_POINT)
            continue;
        bool fits = true;
        for (size_t k = 2; k <= 4; k++)
            fits &= bat_ftm_is_whole(r, i + k, &mark);
        const size_t last = i + 1 + BAT_FTM_LINES_OF_POINT * (size_t)(count - 1);
        if (fits && bat_ftm_numbers_of(bat_ftm_line_of(r, last), 3, xyz) == 3) {
            r->points = i;
            r->point_count = count;
            return BATTEN_OK;
        }
    }
    return bat_input_fail(r->input, BATTEN_BAD_FORMAT, 0, "the model has no control points");
}

static void note_vanished(const bat_ftm_reading *r, bat_span line, const double point[3])
{
    bat_scan words = bat_scan_begin(line.bytes, line.length);
    bat_span word;
    for (int k = 0; k < 3 && bat_next_in_line(&words, &word); k++)
        bat_input_vanished(r->input, (int)r->at + 1, "", word, point[k]);
}

static batten_status read_points(bat_ftm_reading *r)
{
    batten_status status = bat_input_limit(r->input, (int)r->points + 1, (size_t)r->point_count,
                                           r->input->limits.points, "points");
    if (status == BATTEN_OK)
        status = bat_input_array(r->input, (size_t)r->point_count, 3 * sizeof(double),
                                 &r->coordinates);
    r->at = r->points + 1;
    for (int i = 0; status == BATTEN_OK && i < r->point_count; i++) {
        const bat_span line = bat_ftm_line_of(r, r->at);
        double *point = &r->coordinates[3 * (size_t)i];
        if (bat_ftm_numbers_of(line, 3, point) == 3)
            note_vanished(r, line, point);
        else
            status = bat_input_fail(r->input, BATTEN_BAD_FORMAT, (int)r->at + 1,
                                    "point %d does not have three coordinates", i + 1);
        r->at += BAT_FTM_LINES_OF_POINT;
    }
    return status;
}

/* Layers stand before the points: their number, 12 lines for each, one line more. */
static void find_layers(bat_ftm_reading *r)
{
    for (int count = 1; count <= 1000; count++) {
        const size_t back = (size_t)count * BAT_FTM_LINES_OF_LAYER + 2;
        int stated = 0;
        if (back > r->points)
            return;
        if (bat_ftm_is_whole(r, r->points - back, &stated) && stated == count) {
            r->layer_count = count;
            r->layers = r->points - back + 1;
            return;
        }
    }
}

static batten_status read_edges(bat_ftm_reading *r)
{
    int count = 0;
    batten_status status =
        bat_ftm_next_count(r, "the number of edges", BAT_FTM_LINES_OF_EDGE, &count);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        int ends[2], crease = 0, mark = 0;
        for (int k = 0; status == BATTEN_OK && k < 2; k++)
            status =
                bat_ftm_next_whole(r, "an end of an edge", 0, r->point_count - 1, &ends[k]);
        if (status == BATTEN_OK)
            status = bat_ftm_next_whole(r, "the mark of a crease", 0, 1, &crease);
        if (status == BATTEN_OK)
            status = bat_ftm_next_whole(r, "a mark of an edge", INT_MIN, INT_MAX, &mark);
        if (status == BATTEN_OK)
            r->crease_count += crease;
    }
    return status;
}

static batten_status read_curve(bat_ftm_reading *r)
{
    int count = 0, index = 0;
    batten_status status = bat_ftm_next_count(r, "the number of points of a curve", 1, &count);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = bat_ftm_next_whole(r, "a point of a curve", 0, r->point_count - 1, &index);
    if (status == BATTEN_OK)
        status = bat_ftm_next_whole(r, "a mark of a curve", INT_MIN, INT_MAX, &index);
    return status;
}

/* Curves that run through points of the net. */
static batten_status read_curves(bat_ftm_reading *r)
{
    batten_status status = bat_ftm_next_count(r, "the number of curves", 3, &r->curve_count);
    for (int i = 0; status == BATTEN_OK && i < r->curve_count; i++)
        status = read_curve(r);
    return status;
}

/* A face of several corners as a fan of triangles. */
static batten_status read_face(bat_ftm_reading *r)
{
    int count = 0, corners[BAT_FTM_CORNERS], layer = 0, mark = 0;
    batten_status status =
        bat_ftm_next_whole(r, "the number of corners of a face", 3, BAT_FTM_CORNERS, &count);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status =
            bat_ftm_next_whole(r, "a corner of a face", 0, r->point_count - 1, &corners[k]);
    if (status == BATTEN_OK)
        status = bat_ftm_next_whole(r, "the layer of a face", 0,
                                    bat_max_int(r->layer_count, 1) - 1, &layer);
    if (status == BATTEN_OK)
        status = bat_ftm_next_whole(r, "a mark of a face", INT_MIN, INT_MAX, &mark);
    r->cut_up += status == BATTEN_OK && count > 3;
    for (int k = 1; status == BATTEN_OK && k + 1 < count; k++) {
        const int triangle[3] = {corners[0], corners[k], corners[k + 1]};
        status = bat_list_add(r->input, &r->corners, triangle);
        if (status == BATTEN_OK)
            status = bat_list_add(r->input, &r->owners, &layer);
    }
    return status;
}

static batten_status read_faces(bat_ftm_reading *r)
{
    int count = 0;
    batten_status status = bat_ftm_next_count(r, "the number of faces", 6, &count);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = read_face(r);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_census_read(r->input, &r->census, "face of the control net");
    return status;
}

/* ---- meshes ---- */

static void note_rest(const bat_ftm_reading *r)
{
    const bat_input *input = r->input;
    bat_remark_polygons(input, r->cut_up);
    batten_notes_add(
        input->notes, input->file, 0, "",
        "the control net is read; the subdivision surface that it stands for, with "
        "%d crease%s and %d curve%s, is not made",
        r->crease_count, bat_plural(r->crease_count), r->curve_count,
        bat_plural(r->curve_count));
}

static batten_status read_all(bat_ftm_reading *r)
{
    batten_status status = bat_ftm_split_lines(r);
    if (status == BATTEN_OK)
        status = find_points(r);
    if (status == BATTEN_OK)
        status = read_points(r);
    if (status == BATTEN_OK) {
        find_layers(r);
        status = read_edges(r);
    }
    if (status == BATTEN_OK)
        status = read_curves(r);
    if (status == BATTEN_OK)
        status = read_faces(r);
    if (status != BATTEN_OK)
        return status;
    bat_ftm_drop_lines(r);
    return bat_ftm_add_layers(r);
}

batten_status bat_read_ftm(bat_input *input, batten_model **out)
{
    bat_ftm_reading r = {.input = input,
                         .lines = {.size = sizeof(uint32_t)},
                         .corners = {.size = 3 * sizeof(int)},
                         .owners = {.size = sizeof(int)}};
    bat_census_begin(&r.census);
    batten_status status = read_all(&r);
    if (status == BATTEN_OK) {
        note_rest(&r);
        bat_census_note(input, &r.census);
        *out = batten_model_ref(r.model);
    }
    batten_model_unref(r.model);
    bat_census_end(&r.census);
    bat_release(r.lines.items);
    bat_release(r.coordinates);
    bat_release(r.corners.items);
    bat_release(r.owners.items);
    bat_release(r.order);
    bat_release(r.ends);
    return status;
}
