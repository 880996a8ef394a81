/* The table of offsets of a lines plan: what its lines measure at each station. */
#include "picture/drawings/lines_plan.h"

#include <stdio.h>

/* Rows and columns in letters: a row is as high as a number and its room. */
static const double row_height = 1.05, letter = 0.72, column_width = 3.4;
enum { HEADER_ROWS = 2, FIXED_COLUMNS = 4 };

typedef struct {
    bat_canvas *canvas;
    const bat_lines_sheet *sheet;
    double left, top, em;
    int decimals;
} table;

static void write_cell(const table *t, int row, int column, bat_colour colour, const char *text)
{
    bat_canvas_text(t->canvas, colour, letter * t->em, BAT_RIGHT,
                    t->left + (column + 0.9) * column_width * t->em,
                    t->top + (row + 0.5) * row_height * t->em, text);
}

static void write_number(const table *t, int row, int column, double value)
{
    char text[BATTEN_NUMBER_SIZE];
    bat_number_text(value, t->decimals, text);
    write_cell(t, row, column, bat_ink, isnan(value) ? "\u2013" : text);
}

static void write_row(const table *t, int station)
{
    const bat_lines_sheet *s = t->sheet;
    const bat_lines_ends e = bat_lines_ends_of(s, station);
    char name[16];
    snprintf(name, sizeof name, "%d", station);
    const int row = HEADER_ROWS + station;
    write_cell(t, row, 0, bat_ink, name);
    write_number(t, row, 1, e.keel);
    write_number(t, row, 2, e.sheer);
    write_number(t, row, 3, e.breadth);
    int column = FIXED_COLUMNS;
    static const bat_family order[] = {BAT_WATERLINES, BAT_BUTTOCKS};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < s->hull.families[order[k]].count; i++)
            write_number(t, row, column++, bat_lines_offset(s, station, order[k], i));
}

static void write_header(const table *t)
{
    static const char *const fixed[FIXED_COLUMNS] = {"station", "keel z", "sheer z", "sheer y"};
    static const bat_family order[] = {BAT_WATERLINES, BAT_BUTTOCKS};
    static const char *const titles[] = {"half-breadths at waterlines", "heights at buttocks"};
    const bat_lines_sheet *s = t->sheet;
    int column = FIXED_COLUMNS;
    bat_canvas_bold(t->canvas, bat_ink, 0.8 * t->em, BAT_LEFT, t->left, t->top - 0.7 * t->em,
                    "Table of offsets");
    for (int i = 0; i < FIXED_COLUMNS; i++)
        write_cell(t, 1, i, bat_grey, fixed[i]);
    for (int k = 0; k < 2; k++) {
        const bat_cuts *cuts = &s->hull.families[order[k]];
        if (cuts->count > 0)
            bat_canvas_text(t->canvas, bat_lines_colours[order[k]], letter * t->em, BAT_LEFT,
                            t->left + (column + 0.2) * column_width * t->em,
                            t->top + 0.5 * row_height * t->em, titles[k]);
        for (int i = 0; i < cuts->count; i++) {
            char text[BATTEN_NUMBER_SIZE];
            bat_number_text(cuts->cuts[i].at, t->decimals, text);
            write_cell(t, 1, column++, bat_lines_colours[order[k]], text);
        }
    }
}

static void table_size(const bat_lines_sheet *s, double size[2])
{
    const bat_cuts *cuts = s->hull.families;
    size[0] = column_width *
              (FIXED_COLUMNS + cuts[BAT_WATERLINES].count + cuts[BAT_BUTTOCKS].count + 0.5);
    size[1] = 1.6 + row_height * (HEADER_ROWS + cuts[BAT_STATIONS].count);
}

bool bat_lines_draw_table(bat_canvas *canvas, const bat_lines_sheet *s)
{
    double size[2];
    table_size(s, size);
    /* Smaller letters than three quarters of the others are not read on paper. */
    const double share = bat_min(1, bat_min(s->table.width / (size[0] * canvas->em),
                                            s->table.height / (size[1] * canvas->em)));
    if (!(share >= 0.75))
        return false;
    const double em = share * canvas->em;
    const table t = {canvas,     s,
                     s->table.x, s->table.y + 1.6 * em,
                     em,         3 - (int)floor(bat_log10(s->hull.high[0] - s->hull.low[0]))};
    const double right = t.left + size[0] * em, line = t.top + HEADER_ROWS * row_height * em;
    write_header(&t);
    bat_canvas_segment(canvas, (bat_pen){bat_grey, 0.6, BAT_SOLID}, t.left, line, right, line);
    for (int i = 0; i < s->hull.families[BAT_STATIONS].count; i++)
        write_row(&t, i);
    return true;
}
