/* What release 2000 asks for besides the entities, and who owns what. */
#include "exchange/dxf/groups.h"
#include "exchange/shapes/paths.h"

enum { HANDLES = 256 };

static const char *const header =
    "0 SECTION|2 HEADER|9 $ACADVER|1 AC1015|9 $DWGCODEPAGE|3 ANSI_1252|9 $HANDSEED|5|"
    "9 $INSUNITS|70 4|9 $MEASUREMENT|70 1|0 ENDSEC|0 SECTION|2 CLASSES|0 ENDSEC|";

#define TABLE(name, rows) "0 TABLE|2 " name "|5|330 of nothing|100 AcDbSymbolTable|70 " rows "|"
#define ROW(kind, table, subclass, name)                                                     \
    "0 " kind "|5|330 of TABLE " table "|100 AcDbSymbolTableRecord|100 " subclass "|2 " name \
    "|70 0|"
#define LINE_TYPE(name) \
    ROW("LTYPE", "LTYPE", "AcDbLinetypeTableRecord", name) "3 |72 65|73 0|40 0|"
#define END "0 ENDTAB|"

static const char *const tables = "0 SECTION|2 TABLES|" TABLE("VPORT", "0") END TABLE(
    "LTYPE", "3") LINE_TYPE("ByBlock") LINE_TYPE("ByLayer") LINE_TYPE("Continuous")
    END TABLE("LAYER", "2") ROW(
        "LAYER", "LAYER", "AcDbLayerTableRecord",
        "0") "62 7|6 Continuous|" ROW("LAYER", "LAYER", "AcDbLayerTableRecord",
                                      "keel") "62 7|6 Continuous|" END TABLE("STYLE", "1")
        ROW("STYLE", "STYLE", "AcDbTextStyleTableRecord",
            "Standard") "40 0|41 1|50 0|71 0|42 1|3 txt|4 |" END TABLE("VIEW", "0")
            END TABLE("UCS", "0") END TABLE("APPID", "1")
                ROW("APPID", "APPID", "AcDbRegAppTableRecord", "ACAD") END TABLE(
                    "DIMSTYLE",
                    "1") "100 AcDbDimStyleTable|0 DIMSTYLE|105|330 of TABLE DIMSTYLE|"
                         "100 AcDbSymbolTableRecord|100 AcDbDimStyleTableRecord|2 Standard|70 0|" END;

#define RECORD(name)                                                        \
    "0 BLOCK_RECORD|5|330 of TABLE BLOCK_RECORD|100 AcDbSymbolTableRecord|" \
    "100 AcDbBlockTableRecord|2 " name "|340 of nothing|"
#define BLOCK(name, paper)                                                                   \
    "0 BLOCK|5|330 of BLOCK_RECORD " name "|100 AcDbEntity|" paper "8 0|100 AcDbBlockBegin|" \
    "2 " name "|70 0|10 0|20 0|30 0|3 " name "|1 |"                                          \
    "0 ENDBLK|5|330 of BLOCK_RECORD " name "|100 AcDbEntity|" paper "8 0|100 AcDbBlockEnd|"

static const char *const blocks =
    TABLE("BLOCK_RECORD", "2") RECORD("*Model_Space") RECORD("*Paper_Space") END
    "0 ENDSEC|"
    "0 SECTION|2 BLOCKS|" BLOCK("*Model_Space", "") BLOCK("*Paper_Space", "67 1|") "0 ENDSEC|";

static const char *const rest =
    "0 SECTION|2 ENTITIES|0 POINT|5|330 of BLOCK_RECORD *Model_Space|100 AcDbEntity|8 keel|"
    "100 AcDbPoint|10 1|20 2|30 3|0 ENDSEC|"
    "0 SECTION|2 OBJECTS|0 DICTIONARY|5|330 of nothing|100 AcDbDictionary|3 ACAD_GROUP|"
    "350 of DICTIONARY |0 DICTIONARY|5|330 of DICTIONARY |100 AcDbDictionary|0 ENDSEC|0 EOF|";

typedef struct {
    char of[HANDLES][2 * VALUE]; /* "KIND NAME" of what has this handle */
} owners;

/* Where each handle is given, and to what; each to one thing alone, below the seed. */
static void find_owners(const char *text, owners *found)
{
    char value[VALUE], kind[VALUE] = "";
    int code = -1;
    long handle = 0, seed = HANDLES;
    for (const char *at = text; (at = next_group(at, &code, value));) {
        if (code == 9 && strcmp(value, "$HANDSEED") == 0) {
            at = next_group(at, &code, value);
            seed = strtol(value, NULL, 16);
        } else if (code == 0) {
            memcpy(kind, value, sizeof kind);
            handle = 0;
        } else if (code == 5 || code == 105) {
            handle = strtol(value, NULL, 16);
            CHECK(handle > 0 && handle < seed && seed <= HANDLES && !found->of[handle][0]);
            snprintf(found->of[handle], sizeof found->of[0], "%s ", kind);
        } else if (code == 2 && handle > 0 && strcmp(kind, "TABLE") != 0) {
            strcat(found->of[handle], value);
        }
    }
}

/* Tables have their name before their handle. */
static void name_tables(const char *text, owners *found)
{
    for (const char *at = text; (at = strstr(at, "  0\nTABLE\n  2\n"));) {
        at += strlen("  0\nTABLE\n  2\n");
        const size_t length = strcspn(at, "\n");
        const long handle = strtol(at + length + strlen("\n  5\n"), NULL, 16);
        CHECK(handle > 0 && handle < HANDLES);
        strncat(found->of[handle], at, length);
    }
}

/* All groups, with what they refer to in place of its handle. */
static const char *with_owners(const char *text)
{
    owners *found = test_array(1, sizeof *found);
    char *out = test_array(strlen(text) + 1, 4), value[VALUE], *to = out;
    int code = -1;
    find_owners(text, found);
    name_tables(text, found);
    for (const char *at = text; (at = next_group(at, &code, value));) {
        const long handle = strtol(value, NULL, 16);
        if (code == 5 || code == 105)
            to += sprintf(to, "%d|", code);
        else if (code == 330 || code == 340 || code == 350)
            to += sprintf(to, "%d of %s|", code, handle ? found->of[handle] : "nothing");
        else
            to += sprintf(to, "%d %s|", code, value);
    }
    return out;
}

static const double one[] = {1, 2, 3};
static const batten_object point = {
    .name = "keel", .kind = BATTEN_OBJECT_POINTS, .point_count = 1, .points = one};

TEST(a_dxf_file_has_all_that_release_2000_asks_for)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, &point));

    const char *at = with_owners(written(model, BATTEN_FORMAT_DXF));
    const char *const parts[] = {header, tables, blocks, rest};
    for (int i = 0; i < COUNT(parts); i++) {
        const size_t length = strlen(parts[i]);
        char *here = test_array(length + 1, 1);
        strncpy(here, at, length);
        CHECK_TEXT(here, parts[i]);
        at += length;
    }
    CHECK_TEXT(at, "");
    batten_model_unref(model);
}

/* Inches, feet and miles alone are measured in the English way. */
TEST(units_of_a_dxf_file_are_metric_but_for_inches_feet_and_miles)
{
    static const struct {
        double metres;
        int code, is_metric;
    } units[] = {{0.0254, 1, 0}, {0.3048, 2, 0}, {1609.344, 3, 0}, {0.001, 4, 1},
                 {1, 6, 1},      {0.123, 0, 1},  {10, 15, 1}};
    for (int i = 0; i < COUNT(units); i++) {
        batten_model *model = NULL;
        char words[80];
        CHECK_OK(batten_model_create(units[i].metres, &model));
        CHECK_OK(batten_model_add(model, &point));

        snprintf(words, sizeof words, "$INSUNITS\n 70\n%d\n  9\n$MEASUREMENT\n 70\n%d\n",
                 units[i].code, units[i].is_metric);
        CHECK_CONTAINS(written(model, BATTEN_FORMAT_DXF), words);
        batten_model_unref(model);
    }
}
