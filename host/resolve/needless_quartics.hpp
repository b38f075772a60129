// needless_quartics.hpp - leaves out half-spaces whose curve on a sheet would be of fourth degree and cannot be seen.
// Method   The page is cut into boxes until in each of them, in intervals of doubles, some other half-space excludes the sheet, the sheet is missing
//          or the half-space in question holds strictly. Then the face on the page, ties included, is the same without it. A box that is
//          small and tells nothing ends the search.
// Cost     Some ten boxes where the curve is seen; it saves a millisecond's factors, discriminants and resultants where it is not.
#pragma once

#include "host/resolve/scan_rows.hpp"
#include "host/resolve/sheet.hpp"

namespace halfspace {

void drop_needless_quartics(Sheets& sheets, const DotExtent& extent);

}  // namespace halfspace
