/* What a DXF file of release 2000 or 2004 must have besides its entities. */
#include "exchange/dxf/dxf.h"

/* Handles that are known before the file is written; entities get those above. */
enum {
    OWNER_OF_TABLES = 0,
    BLOCK_RECORDS = 1,
    MODEL_SPACE,
    PAPER_SPACE,
    ROOT_DICTIONARY,
    GROUP_DICTIONARY,
    FIRST_FREE = 16
};

static void put_header(bat_dxf *dxf, double unit_metres, bool has_full_colours, int handles)
{
    const int units = bat_dxf_code_of(unit_metres);
    bat_dxf_text(dxf, 0, "SECTION");
    bat_dxf_text(dxf, 2, "HEADER");
    bat_dxf_text(dxf, 9, "$ACADVER");
    bat_dxf_text(dxf, 1, has_full_colours ? "AC1018" : "AC1015");
    bat_dxf_text(dxf, 9, "$DWGCODEPAGE");
    bat_dxf_text(dxf, 3, "ANSI_1252");
    bat_dxf_text(dxf, 9, "$HANDSEED");
    bat_dxf_reference(dxf, 5, handles);
    bat_dxf_text(dxf, 9, "$INSUNITS");
    bat_dxf_integer(dxf, 70, units);
    bat_dxf_text(dxf, 9, "$MEASUREMENT");
    bat_dxf_integer(dxf, 70, units == 1 || units == 2 || units == 3 ? 0 : 1);
    bat_dxf_text(dxf, 0, "ENDSEC");
    bat_dxf_text(dxf, 0, "SECTION");
    bat_dxf_text(dxf, 2, "CLASSES");
    bat_dxf_text(dxf, 0, "ENDSEC");
}

/* ---- tables ---- */

static int begin_table(bat_dxf *dxf, const char *name, int rows)
{
    bat_dxf_text(dxf, 0, "TABLE");
    bat_dxf_text(dxf, 2, name);
    const int table = bat_dxf_handle(dxf, OWNER_OF_TABLES);
    bat_dxf_text(dxf, 100, "AcDbSymbolTable");
    bat_dxf_integer(dxf, 70, rows);
    return table;
}

static void begin_row(bat_dxf *dxf, int table, const char *kind, const char *subclass,
                      const char *name)
{
    bat_dxf_text(dxf, 0, kind);
    bat_dxf_handle(dxf, table);
    bat_dxf_text(dxf, 100, "AcDbSymbolTableRecord");
    bat_dxf_text(dxf, 100, subclass);
    bat_dxf_text(dxf, 2, name);
    bat_dxf_integer(dxf, 70, 0);
}

static void end_table(bat_dxf *dxf)
{
    bat_dxf_text(dxf, 0, "ENDTAB");
}

static void put_empty_table(bat_dxf *dxf, const char *name)
{
    begin_table(dxf, name, 0);
    end_table(dxf);
}

static void put_line_type(bat_dxf *dxf, int table, const char *name)
{
    begin_row(dxf, table, "LTYPE", "AcDbLinetypeTableRecord", name);
    bat_dxf_text(dxf, 3, "");
    bat_dxf_integer(dxf, 72, 65);
    bat_dxf_integer(dxf, 73, 0);
    bat_dxf_real(dxf, 40, 0);
}

static void put_line_types(bat_dxf *dxf)
{
    static const char *const names[] = {"ByBlock", "ByLayer", "Continuous"};
    const int table = begin_table(dxf, "LTYPE", 3);
    for (int i = 0; i < 3; i++)
        put_line_type(dxf, table, names[i]);
    end_table(dxf);
}

void bat_dxf_put_colour(bat_dxf *dxf, bat_dxf_colour_code colour)
{
    bat_dxf_integer(dxf, 62, colour.index);
    if (colour.full >= 0)
        bat_dxf_integer(dxf, 420, colour.full);
}

static void put_layers(bat_dxf *dxf, int count, const bat_dxf_layer_row *layers)
{
    const int table = begin_table(dxf, "LAYER", count);
    for (int i = 0; i < count; i++) {
        begin_row(dxf, table, "LAYER", "AcDbLayerTableRecord", layers[i].name);
        bat_dxf_colour_code colour = layers[i].colour;
        colour.index = layers[i].is_off ? -colour.index : colour.index;
        bat_dxf_put_colour(dxf, colour);
        bat_dxf_text(dxf, 6, "Continuous");
    }
    end_table(dxf);
}

static void put_styles(bat_dxf *dxf)
{
    const int table = begin_table(dxf, "STYLE", 1);
    begin_row(dxf, table, "STYLE", "AcDbTextStyleTableRecord", "Standard");
    bat_dxf_real(dxf, 40, 0);
    bat_dxf_real(dxf, 41, 1);
    bat_dxf_real(dxf, 50, 0);
    bat_dxf_integer(dxf, 71, 0);
    bat_dxf_real(dxf, 42, 1);
    bat_dxf_text(dxf, 3, "txt");
    bat_dxf_text(dxf, 4, "");
    end_table(dxf);
}

static void put_applications(bat_dxf *dxf)
{
    const int table = begin_table(dxf, "APPID", 1);
    begin_row(dxf, table, "APPID", "AcDbRegAppTableRecord", "ACAD");
    end_table(dxf);
}

/* Its rows have their handles under another code, and the table a subclass more. */
static void put_dimension_styles(bat_dxf *dxf)
{
    const int table = begin_table(dxf, "DIMSTYLE", 1);
    bat_dxf_text(dxf, 100, "AcDbDimStyleTable");
    bat_dxf_text(dxf, 0, "DIMSTYLE");
    bat_dxf_reference(dxf, 105, ++dxf->handle);
    bat_dxf_reference(dxf, 330, table);
    bat_dxf_text(dxf, 100, "AcDbSymbolTableRecord");
    bat_dxf_text(dxf, 100, "AcDbDimStyleTableRecord");
    bat_dxf_text(dxf, 2, "Standard");
    bat_dxf_integer(dxf, 70, 0);
    end_table(dxf);
}

static const char *const spaces[] = {"*Model_Space", "*Paper_Space"};

static void put_block_record(bat_dxf *dxf, int space)
{
    bat_dxf_text(dxf, 0, "BLOCK_RECORD");
    bat_dxf_reference(dxf, 5, MODEL_SPACE + space);
    bat_dxf_reference(dxf, 330, BLOCK_RECORDS);
    bat_dxf_text(dxf, 100, "AcDbSymbolTableRecord");
    bat_dxf_text(dxf, 100, "AcDbBlockTableRecord");
    bat_dxf_text(dxf, 2, spaces[space]);
    bat_dxf_reference(dxf, 340, 0);
}

static void put_block_records(bat_dxf *dxf)
{
    bat_dxf_text(dxf, 0, "TABLE");
    bat_dxf_text(dxf, 2, "BLOCK_RECORD");
    bat_dxf_reference(dxf, 5, BLOCK_RECORDS);
    bat_dxf_reference(dxf, 330, OWNER_OF_TABLES);
    bat_dxf_text(dxf, 100, "AcDbSymbolTable");
    bat_dxf_integer(dxf, 70, 2);
    for (int i = 0; i < 2; i++)
        put_block_record(dxf, i);
    end_table(dxf);
}

/* ---- blocks ---- */

static void begin_block_entity(bat_dxf *dxf, int space, const char *kind, const char *subclass)
{
    bat_dxf_text(dxf, 0, kind);
    bat_dxf_handle(dxf, MODEL_SPACE + space);
    bat_dxf_text(dxf, 100, "AcDbEntity");
    if (space == 1)
        bat_dxf_integer(dxf, 67, 1);
    bat_dxf_text(dxf, 8, "0");
    bat_dxf_text(dxf, 100, subclass);
}

static void put_block(bat_dxf *dxf, int space)
{
    static const double origin[3] = {0, 0, 0};
    begin_block_entity(dxf, space, "BLOCK", "AcDbBlockBegin");
    bat_dxf_text(dxf, 2, spaces[space]);
    bat_dxf_integer(dxf, 70, 0);
    bat_dxf_point(dxf, 10, origin);
    bat_dxf_text(dxf, 3, spaces[space]);
    bat_dxf_text(dxf, 1, "");
    begin_block_entity(dxf, space, "ENDBLK", "AcDbBlockEnd");
}

static void put_blocks(bat_dxf *dxf)
{
    bat_dxf_text(dxf, 0, "SECTION");
    bat_dxf_text(dxf, 2, "BLOCKS");
    for (int i = 0; i < 2; i++)
        put_block(dxf, i);
    bat_dxf_text(dxf, 0, "ENDSEC");
}

/* ---- the whole ---- */

void bat_dxf_begin(bat_dxf *dxf, double unit_metres, bool has_full_colours, int layer_count,
                   const bat_dxf_layer_row *layers, int handles, int *model_space)
{
    put_header(dxf, unit_metres, has_full_colours, handles);
    dxf->handle = FIRST_FREE;
    bat_dxf_text(dxf, 0, "SECTION");
    bat_dxf_text(dxf, 2, "TABLES");
    put_empty_table(dxf, "VPORT");
    put_line_types(dxf);
    put_layers(dxf, layer_count, layers);
    put_styles(dxf);
    put_empty_table(dxf, "VIEW");
    put_empty_table(dxf, "UCS");
    put_applications(dxf);
    put_dimension_styles(dxf);
    put_block_records(dxf);
    bat_dxf_text(dxf, 0, "ENDSEC");
    put_blocks(dxf);
    *model_space = MODEL_SPACE;
}

void bat_dxf_end(bat_dxf *dxf)
{
    bat_dxf_text(dxf, 0, "SECTION");
    bat_dxf_text(dxf, 2, "OBJECTS");
    bat_dxf_text(dxf, 0, "DICTIONARY");
    bat_dxf_reference(dxf, 5, ROOT_DICTIONARY);
    bat_dxf_reference(dxf, 330, 0);
    bat_dxf_text(dxf, 100, "AcDbDictionary");
    bat_dxf_text(dxf, 3, "ACAD_GROUP");
    bat_dxf_reference(dxf, 350, GROUP_DICTIONARY);
    bat_dxf_text(dxf, 0, "DICTIONARY");
    bat_dxf_reference(dxf, 5, GROUP_DICTIONARY);
    bat_dxf_reference(dxf, 330, ROOT_DICTIONARY);
    bat_dxf_text(dxf, 100, "AcDbDictionary");
    bat_dxf_text(dxf, 0, "ENDSEC");
    bat_dxf_text(dxf, 0, "EOF");
}
