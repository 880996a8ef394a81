/* `batten help`, which knows the table of all commands. */
#ifndef CLI_HELP_H
#define CLI_HELP_H
#include "command.h"

int help_show(const arguments *given, const command_table *table);

#endif
