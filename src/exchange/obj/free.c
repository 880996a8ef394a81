/* Free-form curves and surfaces: their statements. */

#include "exchange/obj/free.h"
#include <limits.h>
#include <string.h>

/* ---- statements ---- */

static void leave_out(const bat_obj *obj, int line, const char *why)
{
    batten_notes_add(obj->input->notes, obj->input->file, line, "",
                     "the free-form %s is left out: %s",
                     obj->free.open == 1 ? "curve" : "surface", why);
    obj->input->left_out++;
}

void bat_obj_free_close(bat_obj *obj)
{
    if (obj->free.open)
        leave_out(obj, obj->free.line, "its 'end' is missing");
    obj->free.open = 0;
}

static void find_basis(bat_span word, bat_obj_basis *basis)
{
    static const char *const names[] = {"bspline", "bezier", "cardinal", "bmatrix"};
    for (int k = 0; k < 4; k++)
        if (bat_word_is(word, names[k]))
            *basis = (bat_obj_basis)(BAT_OBJ_BSPLINE + k);
}

static void read_type(bat_obj *obj)
{
    bat_obj_free *f = &obj->free;
    bat_span word;
    f->is_rational = false;
    f->basis = BAT_OBJ_OTHER;
    while (bat_obj_next(obj, &word)) {
        f->is_rational = f->is_rational || bat_word_is(word, "rat");
        find_basis(word, &f->basis);
    }
}

/* Two small whole numbers; what is missing or none stays 0. */
static void read_two(bat_obj *obj, int out[2])
{
    bat_span word;
    out[0] = out[1] = 0;
    for (int k = 0; k < 2 && bat_obj_next(obj, &word); k++) {
        int64_t number = 0;
        if (bat_word_integer(word, 1, 1000, &number))
            out[k] = (int)number;
    }
}

/* Numbers until the end of the statement; one that is none becomes NaN. */
static batten_status read_list(bat_obj *obj, bat_list *list)
{
    bat_span word;
    batten_status status = BATTEN_OK;
    list->count = 0;
    while (status == BATTEN_OK && bat_obj_next(obj, &word)) {
        double number;
        if (!bat_word_real(obj->input, obj->scan.line, word, &number))
            number = (double)NAN;
        status = bat_list_add(obj->input, list, &number);
    }
    return status;
}

/* "u" or "v" before the list of a direction. */
static batten_status read_direction(bat_obj *obj, bat_list lists[2])
{
    bat_span word;
    if (!bat_obj_next(obj, &word) || (!bat_word_is(word, "u") && !bat_word_is(word, "v")))
        return BATTEN_OK;
    return read_list(obj, &lists[bat_word_is(word, "v")]);
}

static batten_status begin_shape(bat_obj *obj, int open)
{
    bat_obj_free *f = &obj->free;
    int bad = 0;
    bat_obj_free_close(obj);
    f->open = open;
    f->line = obj->scan.line;
    f->trims = 0;
    f->knots[0].count = f->knots[1].count = f->corners.count = 0;
    for (int k = 0; k < 2 * open; k++)
        if (!bat_obj_number(obj, &f->range[k / 2][k % 2]))
            f->range[k / 2][k % 2] = (double)NAN;
    batten_status status = bat_obj_corners(obj, &f->corners, &bad);
    if (status == BATTEN_OK && bad) {
        leave_out(obj, f->line, "a control point is not an index");
        f->open = 0;
    }
    return status;
}

/* ---- the end of a shape ---- */

static const char *check_shape(const bat_obj *obj, bat_obj_axis d[2])
{
    const bat_obj_free *f = &obj->free;
    const char *wrong = NULL;
    if (f->basis == BAT_OBJ_NO_BASIS)
        return "no 'cstype' stands before it";
    if (f->basis == BAT_OBJ_OTHER)
        return "its 'cstype' is not bspline, bezier, cardinal or bmatrix";
    for (int k = 0; !wrong && k < f->open; k++)
        wrong = bat_obj_check_direction(f, k, &d[k]);
    if (!wrong && (uint64_t)d[0].given * (uint64_t)d[1].given != f->corners.count)
        wrong = "it has not as many control points as its parameters ask for";
    return wrong;
}

static void note_trims(const bat_obj *obj)
{
    if (obj->free.trims) {
        batten_notes_add(obj->input->notes, obj->input->file, obj->free.line, "",
                         "the surface is whole: %d statements that trim it or mark curves and "
                         "points on it are left out",
                         obj->free.trims);
        obj->input->left_out++;
    }
}

static void mark_used(const bat_obj *obj)
{
    bat_obj_vertex *vertices = obj->vertices.items;
    const bat_obj_corner *corners = obj->free.corners.items;
    for (size_t i = 0; i < obj->free.corners.count; i++)
        vertices[corners[i].vertex].is_used = true;
}

void bat_obj_shape_end(const bat_obj_shape *shape)
{
    batten_curve_unref(shape->curve);
    batten_surface_unref(shape->surface);
}

static batten_status keep_shape(bat_obj *obj, bat_obj_shape *shape)
{
    const bat_obj_element element = {
        .kind = BAT_OBJ_SHAPE, .first = obj->shapes.count, .line = obj->free.line};
    batten_status status = bat_list_add(obj->input, &obj->shapes, shape);
    if (status != BATTEN_OK) {
        bat_obj_shape_end(shape);
        return status;
    }
    mark_used(obj);
    note_trims(obj);
    return bat_obj_add(obj, &element);
}

static batten_status end_shape(bat_obj *obj)
{
    bat_obj_axis d[2] = {{.given = 1, .count = 1}, {.given = 1, .count = 1}};
    bat_obj_shape shape = {NULL, NULL};
    batten_status status = BATTEN_OK;
    if (!obj->free.open)
        return BATTEN_OK;
    const char *wrong = check_shape(obj, d);
    for (int k = 0; !wrong && status == BATTEN_OK && k < obj->free.open; k++)
        status = bat_obj_prepare_direction(obj, k, &d[k]);
    if (!wrong && status == BATTEN_OK)
        status = bat_obj_build(obj, d, &shape);
    for (int k = 0; k < 2; k++) {
        bat_release(d[k].knots);
        bat_release(d[k].powers);
    }
    if (!wrong && status == BATTEN_OK)
        status = keep_shape(obj, &shape);
    else if (status != BATTEN_OUT_OF_MEMORY && status != BATTEN_TOO_LARGE) {
        leave_out(obj, obj->free.line, wrong ? wrong : batten_message());
        status = BATTEN_OK;
    }
    obj->free.open = 0;
    return status;
}

static bool is_attached(bat_span word)
{
    static const char *const attached[] = {"trim", "hole", "scrv", "sp"};
    for (int k = 0; k < 4; k++)
        if (bat_word_is(word, attached[k]))
            return true;

    return false;
}

batten_status bat_obj_free_statement(bat_obj *obj, bat_span word, bool *is_such)
{
    *is_such = true;
    if (bat_word_is(word, "cstype"))
        read_type(obj);
    else if (bat_word_is(word, "deg"))
        read_two(obj, obj->free.degree);
    else if (bat_word_is(word, "step"))
        read_two(obj, obj->free.step);
    else if (bat_word_is(word, "bmat"))
        return read_direction(obj, obj->free.matrix);
    else if (bat_word_is(word, "parm"))
        return read_direction(obj, obj->free.knots);
    else if (bat_word_is(word, "curv") || bat_word_is(word, "surf"))
        return begin_shape(obj, bat_word_is(word, "curv") ? 1 : 2);
    else if (bat_word_is(word, "end"))
        return end_shape(obj);
    else if (bat_word_is(word, "curv2")) {
        bat_obj_free_close(
            obj); /* a curve in parameters: only trims use it, which are left out */
        return BATTEN_OK;
    } else {
        const bool is_trim = is_attached(word);
        obj->free.trims += is_trim;
        *is_such = is_trim || bat_word_is(word, "con");
    }
    return BATTEN_OK;
}
