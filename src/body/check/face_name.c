/* How notes on a body name its faces. */
#include "body/check/parts.h"

#include <stdio.h>

const char *bat_check_face_name(const bat_check *check, int face, char name[BAT_CHECK_NAME])
{
    const int number = check->numbers ? check->numbers[face] : face;
    const char *given = check->named->faces[number].name;
    if (given[0])
        snprintf(name, BAT_CHECK_NAME, "face %d \"%.64s\"", number + 1, given);
    else
        snprintf(name, BAT_CHECK_NAME, "face %d", number + 1);
    return name;
}
