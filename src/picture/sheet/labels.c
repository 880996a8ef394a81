/* Labels: at their place or not at all; and names, which look for a place where they cover nothing. */
#include "base/list.h"
#include "picture/sheet/canvas.h"

#include <stdio.h>
#include <string.h>

static bool overlap(bat_rectangle a, bat_rectangle b)
{
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

static bool is_inside(bat_rectangle place, bat_rectangle room)
{
    return place.x >= room.x && place.y >= room.y &&
           place.x + place.width <= room.x + room.width &&
           place.y + place.height <= room.y + room.height;
}

/* No text stands here. */
static bool is_untaken(const bat_canvas *canvas, bat_rectangle place)
{
    for (size_t i = 0; i < canvas->taken_count; i++)
        if (overlap(place, canvas->taken[i]))
            return false;
    return true;
}

/* The text on a white ground, which hides the grid below it. */
static void put_label(bat_canvas *canvas, bat_colour colour, double size, bat_rectangle place,
                      const char *text)
{
    bat_canvas_box(canvas, (bat_colour){1, 1, 1}, place);
    bat_canvas_text(canvas, colour, size, BAT_MIDDLE, place.x + 0.5 * place.width,
                    place.y + 0.5 * place.height, text);
    bat_canvas_take(canvas, place);
}

/* The ground of a text: its middle is put later. */
static bat_rectangle ground_of(bat_canvas *canvas, double size, const char *text)
{
    return (bat_rectangle){0, 0, bat_canvas_text_width(canvas, size, text) + 0.6 * size, size};
}

bool bat_canvas_label(bat_canvas *canvas, bat_colour colour, double size, bat_anchor anchor,
                      double x, double y, const char *text)
{
    if (!*text)
        return true; /* its ground would be a white spot on what is drawn there */
    bat_rectangle place = ground_of(canvas, size, text);
    const double margin = 0.3 * size;
    place.x = x - 0.5 * (double)anchor * (place.width - 2 * margin) - margin;
    place.y = y - 0.5 * size;
    const bat_rectangle sheet = {0, 0, canvas->width, canvas->height};
    if (!is_inside(place, sheet) || !is_untaken(canvas, place))
        return false;
    put_label(canvas, colour, size, place, text);
    return true;
}

/* ---- names ---- */

static bool is_free(const bat_canvas *canvas, bat_rectangle room, bat_rectangle place)
{
    const double box[4] = {place.x, place.y, place.x + place.width, place.y + place.height};
    return is_inside(place, room) && is_untaken(canvas, place) &&
           bat_cover_is_free(&canvas->cover, box);
}

/* Where the leader from (x, y) meets the ground of a name: its nearest point. */
static void meet_ground(bat_rectangle place, double x, double y, double out[2])
{
    out[0] = bat_max(place.x, bat_min(x, place.x + place.width));
    out[1] = bat_max(place.y, bat_min(y, place.y + place.height));
}

/* A leader may cross lines, but no text. */
static bool leads_past_texts(const bat_canvas *canvas, bat_rectangle place, double x, double y)
{
    enum { STEPS = 16 };
    double end[2];
    meet_ground(place, x, y, end);
    for (int i = 0; i < STEPS; i++) {
        const double t = (double)i / STEPS;
        const bat_rectangle here = {x + t * (end[0] - x), y + t * (end[1] - y), 0, 0};
        if (!is_untaken(canvas, here))
            return false;
    }
    return true;
}

/* Beside (x, y) in the ring of this number, where nothing is covered; false when there is no such place. */
static bool place_in_ring(bat_canvas *canvas, const bat_name *name, const double at[2],
                          int ring)
{
    /* To the right first, then up, down, left, and between them. */
    static const double ways[][2] = {{1, 0},      {0.7, -0.7}, {0.7, 0.7},   {0, -1},
                                     {0, 1},      {-1, 0},     {-0.7, -0.7}, {-0.7, 0.7},
                                     {0.9, -0.4}, {0.9, 0.4},  {-0.9, -0.4}, {-0.9, 0.4}};
    const double far = (0.3 + 0.5 * ring) * canvas->em, x = at[0], y = at[1];
    bat_rectangle place = ground_of(canvas, name->how.size, name->text);
    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++) {
        double end[2];
        place.x = x + ways[i][0] * (far + 0.5 * place.width) - 0.5 * place.width;
        place.y = y + ways[i][1] * (far + 0.5 * place.height) - 0.5 * place.height;
        if (!is_free(canvas, name->room, place) || !leads_past_texts(canvas, place, x, y))
            continue;
        meet_ground(place, x, y, end);
        /* What is farther than a letter away needs a leader. */
        if (bat_hypot(end[0] - x, end[1] - y) > 1.2 * canvas->em)
            bat_canvas_segment(canvas, (bat_pen){name->how.colour, 0.4, BAT_SOLID}, x, y,
                               end[0], end[1]);
        put_label(canvas, name->how.colour, name->how.size, place, name->text);
        return true;
    }
    return false;
}

static void place_name(bat_canvas *canvas, const bat_name *name)
{
    enum { NEAR = 2, FAR = 24 }; /* rings, half a letter each */
    for (int ring = 0; ring < (name->how.leads ? FAR : NEAR); ring++)
        for (int i = 0; i < name->count; i++)
            if (place_in_ring(canvas, name, name->at[i], ring))
                return;
}

void bat_canvas_place_names(bat_canvas *canvas)
{
    for (size_t i = 0; i < canvas->name_count; i++)
        place_name(canvas, &canvas->names[i]);
    canvas->name_count = 0;
}

void bat_canvas_name(bat_canvas *canvas, bat_lettering how, int count, const double *at,
                     const char *text)
{
    if (!*text)
        return;
    bat_name name = {
        .how = how, .room = canvas->clip, .count = bat_min_int(count, BAT_NAME_PLACES)};
    memcpy(name.at, at, (size_t)name.count * sizeof *name.at);
    snprintf(name.text, sizeof name.text, "%s", text);
    if (BAT_LIST_ADD(canvas->names, canvas->name_count, canvas->name_capacity, name) !=
        BATTEN_OK)
        canvas->status = BATTEN_OUT_OF_MEMORY;
}
