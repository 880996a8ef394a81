/* A sheet as DXF: entities on layers, in the units of the model. */
#include "picture/sheet/dxf.h"

#include "support/test.h"

/* What follows the head of the file. */
static char *entities_of(bat_dxf_sheet *sheet)
{
    char *data = NULL;
    size_t size = 0;
    batten_status status = bat_dxf_sheet_finish(sheet, &data, &size);
    if (test_memory_failed(status, BATTEN_OK))
        return NULL;
    CHECK_INT(status, BATTEN_OK);
    char *copy = test_array(size + 1, 1);
    memcpy(copy, data, size);
    batten_release(data);
    CHECK_CONTAINS(copy, "$ACADVER\n  1\nAC1009\n");
    char *found = strstr(copy, "ENTITIES\n");
    CHECK(found != NULL);
    return found + strlen("ENTITIES\n");
}

TEST(lines_are_written_at_the_scale_of_the_model)
{
    bat_dxf_sheet sheet = bat_dxf_sheet_begin();
    sheet.scale = 4;
    sheet.x = 10;
    sheet.y = 20;
    sheet.layer = BAT_LAYER_GRID;
    const double xy[] = {10, 20, 14, 12, 14, 12, 30, 21};
    bat_dxf_sheet_line(&sheet, 1, xy); /* no line */
    bat_dxf_sheet_line(&sheet, 2, xy);
    sheet.layer = BAT_LAYER_DIAGONALS;
    bat_dxf_sheet_line(&sheet, 4, xy); /* one point twice */
    const char *found = entities_of(&sheet);
    if (found)
        CHECK_TEXT(found,
                   "  0\nLINE\n  8\ngrid\n 10\n0\n 20\n0\n 30\n0\n 11\n1\n 21\n2\n 31\n0\n"
                   "  0\nPOLYLINE\n  8\ndiagonals\n 66\n1\n 10\n0\n 20\n0\n 30\n0\n 70\n0\n"
                   "  0\nVERTEX\n  8\ndiagonals\n 10\n0\n 20\n0\n 30\n0\n"
                   "  0\nVERTEX\n  8\ndiagonals\n 10\n1\n 20\n2\n 30\n0\n"
                   "  0\nVERTEX\n  8\ndiagonals\n 10\n5\n 20\n-0.25\n 30\n0\n"
                   "  0\nSEQEND\n  8\ndiagonals\n"
                   "  0\nENDSEC\n  0\nEOF\n");
}

/* Letters as they are written. */
static const struct {
    const char *text, *written;
} texts[] = {{"WL 0.5", "WL 0.5"},      {"45\u00b0 down", "45%%d down"},
             {"\u2013", "\\U+2013"},    {"a\nb\x01", "ab"},
             {"\xff|\xe2\x80", "?|??"}, {"\u00e9\U0001f6a2", "\\U+00E9\\U+1F6A2"}};

TEST(texts_are_plain_letters_on_their_layer)
{
    static const bat_layer layers[] = {BAT_LAYER_STATIONS, BAT_LAYER_TABLE};
    static const char *const names[] = {"text", "table"};
    for (int i = 0; i < COUNT(texts); i++)
        for (int k = 0; k < 2; k++) {
            bat_dxf_sheet sheet = bat_dxf_sheet_begin();
            sheet.scale = 2;
            sheet.layer = layers[k];
            bat_dxf_sheet_text(
                &sheet, &(bat_dxf_letters){
                            .size = 100, .x = 6, .y = -8, .anchor = 2, .text = texts[i].text});
            char expected[400];
            snprintf(expected, sizeof expected,
                     "  0\nTEXT\n  8\n%s\n 10\n3\n 20\n-14\n 30\n0\n 40\n36\n  1\n%s\n 72\n2\n"
                     " 11\n3\n 21\n4\n 31\n0\n 73\n2\n  0\nENDSEC\n  0\nEOF\n",
                     names[k], texts[i].written);
            const char *found = entities_of(&sheet);
            if (found)
                CHECK_TEXT(found, expected);
        }
}

TEST(all_layers_are_declared)
{
    static const char *const names[] = {"stations", "buttocks", "waterlines", "diagonals",
                                        "edges",    "points",   "grid",       "text",
                                        "table",    "sheet"};
    bat_dxf_sheet sheet = bat_dxf_sheet_begin();
    char *data = NULL;
    size_t size = 0;
    const batten_status status = bat_dxf_sheet_finish(&sheet, &data, &size);
    if (test_memory_failed(status, BATTEN_OK))
        return; /* a sheet is finished once */
    CHECK_INT(status, BATTEN_OK);
    CHECK_CONTAINS(data, "LAYER\n 70\n10\n");
    for (int i = 0; i < COUNT(names); i++) {
        char row[80];
        snprintf(row, sizeof row, "  0\nLAYER\n  2\n%s\n 70\n0\n 62\n", names[i]);
        CHECK_CONTAINS(data, row);
    }
    batten_release(data);
}
