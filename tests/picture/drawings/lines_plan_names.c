/* Lines are named by their family and place. */
#include "picture/drawings/lines_plan.h"
#include "picture/scenes.h"

TEST(names_tell_family_and_place)
{
    bat_cut cuts[] = {{.at = 0.25}, {.at = 1.5, .is_design = true}};
    bat_lines_sheet s = {.model = NULL};
    for (int f = 0; f < BAT_FAMILIES; f++)
        s.hull.families[f] = (bat_cuts){.count = 2, .cuts = cuts};
    for (int k = 0; k < 3; k++)
        s.hull.high[k] = 5;
    static const struct {
        bat_family family;
        const char *names[2];
    } rows[] = {{BAT_STATIONS, {"0", "1"}},
                {BAT_BUTTOCKS, {"B 0.25", "DWL 1.5"}},
                {BAT_WATERLINES, {"WL 0.25", "DWL 1.5"}},
                {BAT_DIAGONALS, {"D1", "D2"}}};
    for (int i = 0; i < COUNT(rows); i++)
        for (int k = 0; k < 2; k++) {
            char text[48];
            bat_lines_name(&s, rows[i].family, k, text);
            CHECK_TEXT(text, rows[i].names[k]);
        }
}
