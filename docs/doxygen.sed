# SPDX-License-Identifier: MIT
# What Doxygen reads: the comment at the head of a file documents it; in comments a < is a sign, not
# HTML, except in `code`.
1,/^#pragma once/ {
  s@^// SPDX.*@/// \\file@
  s@^//([^/].*)?$@///\1@
  s@^(///.*>)::@\1\\::@
}
:again
s@^(.*///<?([^<`]|`[^`]*`)*)<([A-Za-z/])@\1\&lt;\3@
t again
