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

/* The families that have columns, in their order; the short title is for few columns. */
static const struct {
    bat_family family;
    const char *title, *short_title;
} blocks[] = {{BAT_WATERLINES, "half-breadths at waterlines", "y at WL"},
              {BAT_BUTTOCKS, "heights at buttocks", "z at B"},
              {BAT_DIAGONALS, "lengths along diagonals", "along D"}};
enum { BLOCKS = sizeof blocks / sizeof blocks[0], KNUCKLE_COLUMNS = 2 };

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
    for (int i = 0; i < s->hull.knuckle_count; i++) {
        double yz[2];
        bat_lines_knuckle_offsets(s, station, i, yz);
        write_number(t, row, column++, yz[1]);
        write_number(t, row, column++, yz[0]);
    }
    for (int k = 0; k < BLOCKS; k++)
        for (int i = 0; i < s->hull.families[blocks[k].family].count; i++)
            write_number(t, row, column++, bat_lines_offset(s, station, blocks[k].family, i));
}

/* Over the columns from this one on. */
static void write_block_title(const table *t, int column, bat_colour colour, const char *text)
{
    bat_canvas_text(t->canvas, colour, letter * t->em, BAT_LEFT,
                    t->left + (column + 0.2) * column_width * t->em,
                    t->top + 0.5 * row_height * t->em, text);
}

/* Does a title have room over so many columns? */
static bool has_room(const table *t, int columns, const char *text)
{
    return bat_canvas_text_width(t->canvas, letter * t->em, text) <=
           (columns - 0.3) * column_width * t->em;
}

/* Heights and half-breadths of the knuckles, each under its name or its number. */
static void head_knuckles(const table *t)
{
    for (int i = 0; i < t->sheet->hull.knuckle_count; i++) {
        const int column = FIXED_COLUMNS + KNUCKLE_COLUMNS * i;
        const char *name = t->sheet->hull.knuckles[i].name;
        char number[BAT_KNUCKLE_NAME];
        snprintf(number, sizeof number, "knuckle %d", i + 1);
        write_block_title(t, column, bat_ink,
                          has_room(t, KNUCKLE_COLUMNS, name) ? name : number);
        write_cell(t, 1, column, bat_grey, "z");
        write_cell(t, 1, column + 1, bat_grey, "y");
    }
}

static void write_header(const table *t)
{
    static const char *const fixed[FIXED_COLUMNS] = {"station", "keel z", "sheer z", "sheer y"};
    const bat_lines_sheet *s = t->sheet;
    int column = FIXED_COLUMNS + KNUCKLE_COLUMNS * s->hull.knuckle_count;
    bat_canvas_bold(t->canvas, bat_ink, 0.8 * t->em, BAT_LEFT, t->left, t->top - 0.7 * t->em,
                    "Table of offsets");
    for (int i = 0; i < FIXED_COLUMNS; i++)
        write_cell(t, 1, i, bat_grey, fixed[i]);
    head_knuckles(t);
    for (int k = 0; k < BLOCKS; k++) {
        const bat_family family = blocks[k].family;
        const bat_cuts *cuts = &s->hull.families[family];
        if (cuts->count > 0)
            write_block_title(t, column, bat_lines_colours[family],
                              has_room(t, cuts->count, blocks[k].title)
                                  ? blocks[k].title
                                  : blocks[k].short_title);
        for (int i = 0; i < cuts->count; i++) {
            char text[48];
            bat_number_text(cuts->cuts[i].at, t->decimals, text);
            if (family == BAT_DIAGONALS)
                bat_lines_name(s, family, i, text);
            write_cell(t, 1, column++, bat_lines_colours[family], text);
        }
    }
}

/* Where the diagonals lie, below the table: so many in a row, each over so many columns. */
enum { DIAGONALS_IN_ROW = 3 };
static const double columns_of_diagonal = 3.6;

static int rows_of_diagonals(const bat_lines_sheet *s)
{
    return (s->hull.families[BAT_DIAGONALS].count + DIAGONALS_IN_ROW - 1) / DIAGONALS_IN_ROW;
}

static void write_diagonals(const table *t)
{
    const bat_hull *hull = &t->sheet->hull;
    const double top =
        t->top + (HEADER_ROWS + hull->families[BAT_STATIONS].count + 0.7) * row_height * t->em;
    for (int i = 0; i < hull->families[BAT_DIAGONALS].count; i++) {
        const bat_cut *cut = &hull->families[BAT_DIAGONALS].cuts[i];
        char name[48], at[BATTEN_NUMBER_SIZE], fall[BATTEN_NUMBER_SIZE], text[160];
        bat_lines_name(t->sheet, BAT_DIAGONALS, i, name);
        bat_number_text(cut->at, t->decimals, at);
        bat_digits_text(cut->angle * 180 / BAT_PI, 4, fall);
        snprintf(text, sizeof text, "%s from %s, %s\u00b0 down", name, at, fall);
        bat_canvas_text(t->canvas, bat_lines_colours[BAT_DIAGONALS], letter * t->em, BAT_LEFT,
                        t->left + (0.4 + columns_of_diagonal * (i % DIAGONALS_IN_ROW)) *
                                      column_width * t->em,
                        top + (double)(i / DIAGONALS_IN_ROW) * row_height * t->em, text);
    }
}

static void table_size(const bat_lines_sheet *s, double size[2])
{
    const bat_cuts *cuts = s->hull.families;
    int columns = FIXED_COLUMNS + KNUCKLE_COLUMNS * s->hull.knuckle_count;
    for (int k = 0; k < BLOCKS; k++)
        columns += cuts[blocks[k].family].count;
    size[0] = column_width * (columns + 0.5);
    size[1] = 1.6 + row_height *
                        (HEADER_ROWS + cuts[BAT_STATIONS].count + 1.2 * rows_of_diagonals(s));
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
    write_diagonals(&t);
    return true;
}
