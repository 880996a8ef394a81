/* Complaints on standard error, with bytes that a terminal would obey made visible. */
#include "complain.h"

#include <batten/text.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static void print_escaped(const char *line)
{
    for (const unsigned char *c = (const unsigned char *)line; *c; c++) {
        if (*c < 0x20 || *c == 0x7f)
            fprintf(stderr, "\\x%02x", *c);
        else
            fputc(*c, stderr);
    }
}

void complain(const char *format, ...)
{
    char line[4096];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);

    print_escaped(line);
    fputc('\n', stderr);
}

/* Levenshtein's distance of short words; long ones are far from everything. */
static int distance(const char *a, const char *b)
{
    enum { LONGEST = 32 };
    const int n = (int)strlen(a), m = (int)strlen(b);
    if (n > LONGEST || m > LONGEST)
        return LONGEST;
    int row[LONGEST + 1];
    for (int j = 0; j <= m; j++)
        row[j] = j;
    for (int i = 1; i <= n; i++) {
        int diagonal = row[0];
        row[0] = i;
        for (int j = 1; j <= m; j++) {
            const int replaced = diagonal + (a[i - 1] != b[j - 1]);
            const int dropped = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
            diagonal = row[j];
            row[j] = replaced < dropped ? replaced : dropped;
        }
    }
    return row[m];
}

const char *nearest_name(const char *word, int count, const char *const *names)
{
    const char *best = NULL;
    int least = (int)(strlen(word) + 2) / 3 + 1;
    for (int i = 0; i < count; i++) {
        const int d = distance(word, names[i]);
        if (d < least) {
            least = d;
            best = names[i];
        }
    }
    return best;
}

static bool holds(int count, const char *const *names, const char *name)
{
    for (int i = 0; i < count; i++)
        if (strcmp(names[i], name) == 0)
            return true;
    return false;
}

int nearest_names(const char *word, int count, const char *const *names, int most,
                  const char **out)
{
    enum { MOST = 8 };
    int found = 0, distances[MOST];
    most = most < MOST ? most : MOST;
    for (int i = 0; i < count; i++) {
        const int d = distance(word, names[i]);
        if ((found == most && d >= distances[found - 1]) || holds(found, out, names[i]))
            continue;
        int at = found < most ? found++ : found - 1;
        for (; at > 0 && distances[at - 1] > d; at--) {
            distances[at] = distances[at - 1];
            out[at] = out[at - 1];
        }
        distances[at] = d;
        out[at] = names[i];
    }
    return found;
}
