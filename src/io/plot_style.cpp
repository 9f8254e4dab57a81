// SPDX-License-Identifier: MIT
// The style sheet of the pictures: colours for light and dark that colour-blind readers can tell
// apart, too.
#include "hodograph/io/svg.hpp"

namespace hodograph {

std::string_view plot_style() {
  return R"(.hg-plot{font:12px system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif}
.hg-paper{fill:#fff}
.hg-title{fill:#1b2733;font-weight:600;font-size:13px}
.hg-text{fill:#51606e}
.hg-unit{fill:#51606e;font-weight:400;font-size:12px}
.hg-end{text-anchor:end}
.hg-middle{text-anchor:middle}
.hg-halo{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}
.hg-grid,.hg-axis,.hg-mark,.hg-level,.hg-line,.hg-arrow{fill:none}
.hg-grid{stroke:#e4e9ee;stroke-width:1}
.hg-axis{stroke:#8b99a6;stroke-width:1}
.hg-mark{stroke:#8b99a6;stroke-width:1}
.hg-level{stroke:#51606e;stroke-width:1.25;stroke-dasharray:6 4}
.hg-line{stroke-width:1.75;stroke-linejoin:round;stroke-linecap:round}
.hg-dash{stroke-dasharray:5 4;stroke-linecap:butt}
.hg-thin{stroke-width:.75;stroke-opacity:.6}
.hg-arrow{stroke-width:1.25;stroke-linecap:round;stroke-linejoin:round}
.hg-ring{stroke:#fff;stroke-width:1}
.hg-c0{stroke:#0068b5}.hg-dot.hg-c0{fill:#0068b5;stroke:none}
.hg-c1{stroke:#d5500c}.hg-dot.hg-c1{fill:#d5500c;stroke:none}
.hg-c2{stroke:#00896b}.hg-dot.hg-c2{fill:#00896b;stroke:none}
.hg-c3{stroke:#a8448f}.hg-dot.hg-c3{fill:#a8448f;stroke:none}
.hg-c4{stroke:#bd8700}.hg-dot.hg-c4{fill:#bd8700;stroke:none}
.hg-c5{stroke:#4a5865}.hg-dot.hg-c5{fill:#4a5865;stroke:none}
@media screen and (prefers-color-scheme:dark){
.hg-paper{fill:#13181d}
.hg-title{fill:#e8edf2}
.hg-text,.hg-unit{fill:#a3b1be}
.hg-halo{stroke:#13181d}
.hg-grid{stroke:#27313a}
.hg-axis,.hg-mark{stroke:#6b7985}
.hg-level{stroke:#a3b1be}
.hg-c0{stroke:#5cb0f0}.hg-dot.hg-c0{fill:#5cb0f0}
.hg-c1{stroke:#ff8d55}.hg-dot.hg-c1{fill:#ff8d55}
.hg-c2{stroke:#3cc4a0}.hg-dot.hg-c2{fill:#3cc4a0}
.hg-c3{stroke:#e38fd0}.hg-dot.hg-c3{fill:#e38fd0}
.hg-c4{stroke:#e8bb3f}.hg-dot.hg-c4{fill:#e8bb3f}
.hg-c5{stroke:#b4c0cb}.hg-dot.hg-c5{fill:#b4c0cb}
}
)";
}

}  // namespace hodograph
