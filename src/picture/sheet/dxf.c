/*
 * A sheet as DXF of release 12, which every program reads: lines, polylines and texts on layers.
 * The files of models are written elsewhere: a model has no texts.
 */
#include "picture/sheet/dxf.h"

/* Names, and colours of AutoCAD's index. */
static const struct {
    const char *name;
    int colour;
} layers[BAT_LAYERS] = {[BAT_LAYER_STATIONS] = {"stations", 7},
                        [BAT_LAYER_BUTTOCKS] = {"buttocks", 3},
                        [BAT_LAYER_WATERLINES] = {"waterlines", 5},
                        [BAT_LAYER_DIAGONALS] = {"diagonals", 6},
                        [BAT_LAYER_EDGES] = {"edges", 7},
                        [BAT_LAYER_POINTS] = {"points", 30},
                        [BAT_LAYER_GRID] = {"grid", 8},
                        [BAT_LAYER_TEXT] = {"text", 7},
                        [BAT_LAYER_TABLE] = {"table", 7},
                        [BAT_LAYER_SHEET] = {"sheet", 7}};

static void put_text(bat_dxf_sheet *sheet, int code, const char *value)
{
    batten_text_add(&sheet->file, "%3d\n%s\n", code, value);
}

static void put_integer(bat_dxf_sheet *sheet, int code, int value)
{
    batten_text_add(&sheet->file, "%3d\n%d\n", code, value);
}

static void put_number(bat_dxf_sheet *sheet, int code, double value)
{
    batten_text_add(&sheet->file, "%3d\n", code);
    batten_text_number(&sheet->file, value);
    batten_text_bytes(&sheet->file, "\n", 1);
}

/* A point of the sheet in the plane of the model. */
static void put_point(bat_dxf_sheet *sheet, int code, double x, double y)
{
    put_number(sheet, code, (x - sheet->x) / sheet->scale);
    put_number(sheet, code + 10, (sheet->y - y) / sheet->scale);
    put_number(sheet, code + 20, 0);
}

static void put_layers(bat_dxf_sheet *sheet)
{
    put_text(sheet, 0, "TABLE");
    put_text(sheet, 2, "LAYER");
    put_integer(sheet, 70, BAT_LAYERS);
    for (int i = 0; i < BAT_LAYERS; i++) {
        put_text(sheet, 0, "LAYER");
        put_text(sheet, 2, layers[i].name);
        put_integer(sheet, 70, 0);
        put_integer(sheet, 62, layers[i].colour);
        put_text(sheet, 6, "CONTINUOUS");
    }
    put_text(sheet, 0, "ENDTAB");
}

bat_dxf_sheet bat_dxf_sheet_begin(void)
{
    /* The one line type that layers name must be there. */
    static const char head[] = "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n  0\n"
                               "ENDSEC\n  0\nSECTION\n  2\nTABLES\n  0\nTABLE\n  2\nLTYPE\n"
                               " 70\n1\n  0\nLTYPE\n  2\nCONTINUOUS\n 70\n0\n  3\nSolid line\n"
                               " 72\n65\n 73\n0\n 40\n0.0\n  0\nENDTAB\n";
    static const char entities[] = "  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n";
    bat_dxf_sheet sheet = {.file = BATTEN_TEXT, .scale = 1, .layer = BAT_LAYER_SHEET};
    batten_text_bytes(&sheet.file, head, sizeof head - 1);
    put_layers(&sheet);
    batten_text_bytes(&sheet.file, entities, sizeof entities - 1);
    return sheet;
}

static void begin_entity(bat_dxf_sheet *sheet, const char *kind, bat_layer layer)
{
    put_text(sheet, 0, kind);
    put_text(sheet, 8, layers[layer].name);
}

static void put_segment(bat_dxf_sheet *sheet, const double *xy)
{
    begin_entity(sheet, "LINE", sheet->layer);
    put_point(sheet, 10, xy[0], xy[1]);
    put_point(sheet, 11, xy[2], xy[3]);
}

void bat_dxf_sheet_line(bat_dxf_sheet *sheet, size_t count, const double *xy)
{
    if (count == 2)
        put_segment(sheet, xy);
    if (count <= 2)
        return;
    begin_entity(sheet, "POLYLINE", sheet->layer);
    put_integer(sheet, 66, 1);
    for (int code = 10; code <= 30; code += 10)
        put_number(sheet, code, 0);
    put_integer(sheet, 70, 0);
    for (size_t i = 0; i < count; i++) {
        if (i > 0 && xy[2 * i] == xy[2 * i - 2] && xy[2 * i + 1] == xy[2 * i - 1])
            continue; /* one point twice is one vertex */
        begin_entity(sheet, "VERTEX", sheet->layer);
        put_point(sheet, 10, xy[2 * i], xy[2 * i + 1]);
    }
    begin_entity(sheet, "SEQEND", sheet->layer);
}

/* The next letter of UTF-8 and its number; a byte that begins no letter gives a question mark. */
static const char *next_letter(const char *text, unsigned *letter)
{
    static const struct {
        unsigned char mask, lead;
    } forms[] = {{0x80, 0x00}, {0xe0, 0xc0}, {0xf0, 0xe0}, {0xf8, 0xf0}};
    const unsigned char first = (unsigned char)*text;
    *letter = '?';
    for (int more = 0; more < 4; more++) {
        if ((first & forms[more].mask) != forms[more].lead)
            continue;
        unsigned code = first & (unsigned char)~forms[more].mask;
        for (int i = 1; i <= more; i++) {
            if (((unsigned char)text[i] & 0xc0) != 0x80)
                return text + 1;
            code = code << 6 | ((unsigned char)text[i] & 0x3f);
        }
        *letter = code;
        return text + 1 + more;
    }
    return text + 1;
}

/* Letters beyond ASCII have names of their own; those that end a line are left out. */
static void put_letters(bat_dxf_sheet *sheet, const char *text)
{
    while (*text) {
        unsigned letter;
        text = next_letter(text, &letter);
        if (letter == 0xb0)
            batten_text_add(&sheet->file, "%%%%d");
        else if (letter >= 0x7f)
            batten_text_add(&sheet->file, "\\U+%04X", letter);
        else if (letter >= ' ')
            batten_text_add(&sheet->file, "%c", (char)letter);
    }
    batten_text_bytes(&sheet->file, "\n", 1);
}

void bat_dxf_sheet_text(bat_dxf_sheet *sheet, const bat_dxf_letters *letters)
{
    /* Capitals of a sans face are about 0.72 of its size high, and DXF measures capitals. */
    const double height = 0.72 * letters->size;
    begin_entity(sheet, "TEXT",
                 sheet->layer == BAT_LAYER_TABLE ? BAT_LAYER_TABLE : BAT_LAYER_TEXT);
    put_point(sheet, 10, letters->x, letters->y + 0.5 * height);
    put_number(sheet, 40, height / sheet->scale);
    batten_text_add(&sheet->file, "  1\n");
    put_letters(sheet, letters->text);
    put_integer(sheet, 72, letters->anchor);
    put_point(sheet, 11, letters->x, letters->y);
    put_integer(sheet, 73, 2); /* the middle of the letters is at this height */
}

batten_status bat_dxf_sheet_finish(bat_dxf_sheet *sheet, char **data, size_t *size)
{
    static const char foot[] = "  0\nENDSEC\n  0\nEOF\n";
    batten_text_bytes(&sheet->file, foot, sizeof foot - 1);
    const batten_status status = batten_text_take(&sheet->file, data, size);
    bat_dxf_sheet_free(sheet);
    return status;
}

void bat_dxf_sheet_free(bat_dxf_sheet *sheet)
{
    batten_text_free(&sheet->file);
}
