/* Numbers that options give to an operation, judged before any work. */
#ifndef CLI_VALUE_CHECK_H
#define CLI_VALUE_CHECK_H
#include "command.h"

/* Are all numbers that are given such as the parameters of the operation take? A complaint when
 * not: that is a usage error. NULL: there is no operation. */
bool value_check_all(const command *c, const batten_feature *feature, const arguments *given);

#endif
