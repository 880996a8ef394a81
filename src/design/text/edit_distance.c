/* How many letters two words differ in. */
#include "design/text/edit_distance.h"

#include "base/base.h"
#include <stdlib.h>
#include <string.h>

#define LONGEST_NAME 48

int bat_edit_distance(const char *a, const char *b, int limit)
{
    const int m = (int)strlen(a), n = (int)strlen(b);
    if (m > LONGEST_NAME || n > LONGEST_NAME || abs(m - n) >= limit)
        return limit;
    int rows[3][LONGEST_NAME + 1];
    for (int j = 0; j <= n; j++)
        rows[0][j] = j;
    for (int i = 1; i <= m; i++) {
        int *row = rows[i % 3];
        const int *above = rows[(i + 2) % 3], *before = rows[(i + 1) % 3];
        row[0] = i;
        for (int j = 1; j <= n; j++) {
            row[j] = bat_min_int(above[j], row[j - 1]) + 1;
            row[j] = bat_min_int(row[j], above[j - 1] + (a[i - 1] != b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = bat_min_int(row[j], before[j - 2] + 1);
        }
    }
    return bat_min_int(rows[m % 3][n], limit);
}
