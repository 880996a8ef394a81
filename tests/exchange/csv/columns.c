#include "exchange/csv/columns.h"

#include "exchange/reading.h"

TEST(columns_are_known_by_many_names_with_their_units)
{
    const struct {
        const char *text;
        bat_column_kind kind;
        bool is_letter;
        double unit;
    } cases[] = {
        {"x", BAT_COLUMN_X, true, 0},
        {"Z", BAT_COLUMN_Z, true, 0},
        {"x_m", BAT_COLUMN_X, true, 1},
        {"z_mm", BAT_COLUMN_Z, true, 0.001},
        {"height [m]", BAT_COLUMN_Z, false, 1},
        {"Height(cm)", BAT_COLUMN_Z, false, 0.01},
        {"half_breadth_ft", BAT_COLUMN_Y, false, 0.3048},
        {"Half-Breadth", BAT_COLUMN_Y, false, 0},
        {"half breadth in", BAT_COLUMN_Y, false, 0.0254},
        {"station", BAT_COLUMN_STATION, false, 0},
        {"line", BAT_COLUMN_LINE, false, 0},
        {"section", BAT_COLUMN_SECTION, false, 0},
        {"depth", BAT_COLUMN_OTHER, false, 0},
        {"", BAT_COLUMN_OTHER, false, 0},
        {"a very long name of a column that no table of offsets would ever have",
         BAT_COLUMN_OTHER, false, 0},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        const bat_column column = bat_column_of(cases[i].text);
        CHECK_INT(column.kind, cases[i].kind);
        CHECK_INT(column.is_letter, cases[i].is_letter);
        CHECK_BITS(column.unit_metres, cases[i].unit);
    }
}

TEST(F6_two_units_in_one_header_are_refused)
{
    check_refused("x_m,y_mm\n1,2\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:1: column 5: 'y_mm' is in another unit");
    batten_model *model =
        read_noting("x_m,y\n1,2\n", BATTEN_FORMAT_POINTS, "only some columns give a unit");
    CHECK_BITS(batten_model_unit_metres(model), 1.0);
    batten_model_unref(model);
}

TEST(F6_a_unit_that_is_not_known_is_told)
{
    batten_model *model = read_noting("x [furlong],y\n1,2\n", BATTEN_FORMAT_POINTS,
                                      "unknown unit in 'x [furlong]'");
    CHECK_BITS(batten_model_unit_metres(model), 0.0);
    batten_model_unref(model);
}
