/* Numbers as the reports of a check write them. */
#ifndef BAT_DESIGN_REPORT_PARTS_H
#define BAT_DESIGN_REPORT_PARTS_H
#include "design/outputs/fairness.h"

/* Four digits. */
static inline void bat_report_rounded(batten_text *out, double value)
{
    if (value == 0 || !isfinite(value)) {
        batten_text_number(out, value);
        return;
    }
    const double places = 3 - floor(bat_log10(fabs(value)));
    const double scale = bat_pow(10, fabs(places));
    batten_text_number(out, places >= 0 ? round(value * scale) / scale
                                        : round(value / scale) * scale);
}

static inline void bat_report_length(batten_text *out, const bat_check *check, double value)
{
    bat_report_rounded(out, value);
    batten_text_add(out, " %s", bat_check_unit(check));
}

static inline void bat_report_number(batten_text *out, const char *key, double value)
{
    batten_text_add(out, "\"%s\": ", key);
    if (isfinite(value))
        batten_text_number(out, value);
    else
        batten_text_add(out, "null");
}

static inline void bat_report_point(batten_text *out, const char *key, const double *p)
{
    batten_text_add(out, "\"%s\": [", key);
    for (int k = 0; k < 3; k++) {
        batten_text_number(out, p[k]);
        batten_text_add(out, k < 2 ? ", " : "]");
    }
}

#endif
