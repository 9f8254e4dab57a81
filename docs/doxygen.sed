# SPDX-License-Identifier: MIT
# What Doxygen reads: in comments a < is a sign, not HTML, except in `code`.
:again
s@^(.*///<?([^<`]|`[^`]*`)*)<([A-Za-z/])@\1\&lt;\3@
t again
