/* The names of the lines of a lines plan. */
#include "picture/drawings/lines_plan.h"

#include <stdio.h>

void bat_lines_name(const bat_lines_sheet *s, bat_family family, int i, char text[static 48])
{
    static const char *const letters[] = {[BAT_BUTTOCKS] = "B", [BAT_WATERLINES] = "WL"};
    const bat_cuts *cuts = &s->hull.families[family];
    char number[BATTEN_NUMBER_SIZE];
    if (family == BAT_STATIONS || family == BAT_DIAGONALS) {
        snprintf(text, 48, family == BAT_STATIONS ? "%d" : "D%d",
                 family == BAT_STATIONS ? i : i + 1);
        return;
    }
    const double range = s->hull.high[family] - s->hull.low[family];
    bat_number_text(cuts->cuts[i].at, 3 - (int)floor(bat_log10(range)), number);
    snprintf(text, 48, "%s %s", cuts->cuts[i].is_design ? "DWL" : letters[family], number);
}
