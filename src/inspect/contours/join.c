/* Ends of lines that lie on each other: at seams, poles, and where lines cross. */
#include "inspect/contours/lines.h"

#include "numeric/vector.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    int level, line, end;     /* end 0 or 1 */
    double point[3], away[3]; /* the unit direction from the end into the line */
} tip;

static void turn_tip(const bat_line *line, int end, tip *t)
{
    const size_t last = line->count - 1;
    const double *p = line->points + 3 * (end ? last : 0);
    const double *q = line->points + 3 * (end ? last - 1 : 1);
    const double length = bat_distance(3, p, q);
    for (int k = 0; k < 3; k++) {
        t->point[k] = p[k];
        t->away[k] = length > 0 ? (q[k] - p[k]) / length : 0;
    }
}

static int in_order(const void *a, const void *b)
{
    const tip *s = a, *t = b;
    if (s->level != t->level)
        return s->level < t->level ? -1 : 1;
    if (s->point[0] != t->point[0])
        return s->point[0] < t->point[0] ? -1 : 1;
    return s->line != t->line ? (s->line < t->line ? -1 : 1) : s->end - t->end;
}

/* Give each tip its straightest free neighbour. mates [2 * lines]: 2 * line + end, or -1. */
static void pair_up(size_t count, const tip *tips, double near, int *mates)
{
    for (size_t i = 0; i < count; i++) {
        const tip *s = &tips[i], *best = NULL;
        double straightest = HUGE_VAL;
        if (mates[2 * s->line + s->end] >= 0)
            continue;
        for (size_t j = i + 1;
             j < count && tips[j].level == s->level && tips[j].point[0] - s->point[0] <= near;
             j++) {
            const tip *t = &tips[j];
            const double turned = bat_dot(3, s->away, t->away);
            if (mates[2 * t->line + t->end] >= 0 || turned >= straightest ||
                bat_distance(3, s->point, t->point) > near)
                continue;
            straightest = turned;
            best = t;
        }
        if (!best)
            continue;
        mates[2 * s->line + s->end] = 2 * best->line + best->end;
        mates[2 * best->line + best->end] = 2 * s->line + s->end;
    }
}

/* All points of a line, from the end `from` on. */
static batten_status append(bat_line *to, const bat_line *line, int from, double near)
{
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < line->count && status == BATTEN_OK; i++) {
        const size_t k = from ? line->count - 1 - i : i;
        const double *p = line->points + 3 * k;
        const bool apart =
            to->count == 0 || bat_distance(3, to->points + 3 * (to->count - 1), p) > near;
        if (apart)
            status = bat_line_add(to, p, line->parameters + 2 * k);
        if (!line->smooth || status != BATTEN_OK)
            continue;
        if (apart)
            bat_line_set_arm(to, 0, line->arms + 6 * k + (from ? 3 : 0));
        bat_line_set_arm(to, 1, line->arms + 6 * k + (from ? 0 : 3));
    }
    return status;
}

/* The line that enters `first` at its end `from`, and all that follow; they are used up. */
static batten_status chain(const bat_lines *old, const int *mates, int first, int from,
                           double near, bat_line *out)
{
    int line = first;
    out->level = old->lines[first].level;
    out->smooth = old->lines[first].smooth;
    for (;;) {
        bat_line *part = &old->lines[line];
        const batten_status status = append(out, part, from, near);
        bat_line_free(part);
        if (status != BATTEN_OK)
            return status;
        const int mate = mates[2 * line + !from];
        if (mate < 0)
            return BATTEN_OK;
        line = mate / 2;
        from = mate % 2;
        if (line == first) {
            out->closed = true;
            break;
        }
    }
    while (out->count > 1 &&
           bat_distance(3, out->points, out->points + 3 * (out->count - 1)) <= near) {
        out->count--;
        if (out->smooth)
            memcpy(out->arms, out->arms + 6 * out->count, 3 * sizeof *out->arms);
    }
    return BATTEN_OK;
}

static batten_status merge(bat_lines *lines, const int *mates)
{
    const size_t count = lines->count;
    bat_line *merged = bat_array(count, sizeof *merged);
    size_t made = 0;
    batten_status status = merged ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    /* Chains with ends from these, then what is closed. */
    for (int round = 0; round < 3; round++)
        for (size_t i = 0; i < count && status == BATTEN_OK; i++) {
            const int from = round == 1;
            if (lines->lines[i].count == 0 || (round < 2 && mates[2 * i + (size_t)from] >= 0))
                continue;
            status = chain(lines, mates, (int)i, from, lines->near, &merged[made++]);
        }
    for (size_t i = 0; i < count; i++)
        bat_line_free(&lines->lines[i]);
    bat_release(lines->lines);
    lines->lines = merged;
    lines->count = lines->capacity = made;
    return status;
}

batten_status bat_lines_join(bat_lines *lines)
{
    const size_t count = 2 * lines->count;
    if (count == 0)
        return BATTEN_OK;
    tip *tips = bat_array(count, sizeof *tips);
    int *mates = bat_array(count, sizeof *mates);
    batten_status status = tips && mates ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < count; i++) {
        tips[i] = (tip){
            .level = lines->lines[i / 2].level, .line = (int)(i / 2), .end = (int)(i % 2)};
        turn_tip(&lines->lines[i / 2], tips[i].end, &tips[i]);
        mates[i] = -1;
    }
    if (status == BATTEN_OK) {
        qsort(tips, count, sizeof *tips, in_order);
        pair_up(count, tips, 4 * lines->near, mates);
        status = merge(lines, mates);
    }
    bat_release(mates);
    bat_release(tips);
    return status;
}

batten_status bat_line_add(bat_line *line, const double *point, const double *parameters)
{
    if (line->count == line->capacity) {
        const size_t capacity = 2 * line->capacity + 16;
        double *points = bat_resize(line->points, capacity, 3 * sizeof *points);
        if (points)
            line->points = points;
        double *both = bat_resize(line->parameters, capacity, 2 * sizeof *both);
        if (both)
            line->parameters = both;
        double *arms =
            line->smooth ? bat_resize(line->arms, capacity, 6 * sizeof *arms) : line->arms;
        if (arms)
            line->arms = arms;
        if (!points || !both || (line->smooth && !arms))
            return BATTEN_OUT_OF_MEMORY;
        line->capacity = capacity;
    }
    memcpy(line->points + 3 * line->count, point, 3 * sizeof *point);
    memcpy(line->parameters + 2 * line->count, parameters, 2 * sizeof *parameters);
    line->count++;
    for (int side = 0; side < 2 && line->smooth; side++)
        bat_line_set_arm(line, side, point);
    return BATTEN_OK;
}

void bat_line_set_arm(bat_line *line, int side, const double *arm)
{
    memcpy(line->arms + 6 * (line->count - 1) + 3 * side, arm, 3 * sizeof *arm);
}

void bat_line_free(bat_line *line)
{
    bat_release(line->points);
    bat_release(line->parameters);
    bat_release(line->arms);
    *line = (bat_line){.level = line->level, .smooth = line->smooth};
}

void bat_lines_free(bat_lines *lines)
{
    for (size_t i = 0; i < lines->count; i++)
        bat_line_free(&lines->lines[i]);
    bat_release(lines->lines);
}
