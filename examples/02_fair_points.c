/* Fair measured points: no point moves farther than it may, and the report says how far each
 * did. */
#include <batten/batten.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { COUNT = 41 };

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "%s: %s\n", batten_status_text(status), batten_message());
    exit(1);
}

int main(void)
{
    /* A smooth waterline, read off a drawing to the nearest centimetre. */
    double x[COUNT], y[COUNT], faired[COUNT];
    for (int i = 0; i < COUNT; i++) {
        x[i] = 0.25 * i;
        y[i] = round(100 * (1.5 - 0.03 * pow(x[i] - 4, 2))) / 100;
    }

    const batten_fair_options options = batten_fair_defaults(0.006);
    batten_fair_report report;
    must(batten_fair_points((batten_points){1, COUNT, y}, x, &options, NULL, &report, faired));

    printf("%d points moved, at most %.4f m\n", report.moved_count, report.max_move);
    printf("excess inflections: %d before, %d after\n", report.before.excess_inflections,
           report.after.excess_inflections);
    printf("bending energy: %.4g before, %.4g after\n", report.before.energy,
           report.after.energy);
    const int worse = report.max_move > 0.006 || report.after.energy > report.before.energy;
    batten_fair_report_release(&report);
    return worse;
}
