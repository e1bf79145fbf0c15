// The function along a line as a chart: what goes up on one side of a constraint and down on the other.
//
//     ProfileRange range;                                            kept from frame to frame
//     const ProfileData profile = profile_of(field, line, document, before, 0.02 * seen.sizes().maxCoeff());
//     range.include(profile);
//     draw_profile(canvas, canvas.bounds(), profile, range, {.text_size = 11 * ui::scale()});
//
// Inside, where f > 0, the area between f and zero is orange, outside blue, as on the plate. Constraints that
// lie on the line stand at the value they ask for. Another function of the same line, the one before a
// drag began, is thin and dashed.
//
// Its scale stands still while something is dragged, or one would see the axis move and not the function: it
// grows at once, by a good step so that it does not crawl, and shrinks where all is at rest and most of it
// is empty.
//
// Before it: a Field and a ProfileLine.  After it: a canvas in a panel; a figure's sheet.
#pragma once

#include <vector>

#include "core/editing/hit_test.h"
#include "core/image/canvas.h"
#include "core/implicit/field.h"
#include "core/scene/document.h"
#include "core/window/ui_style.h"

namespace seesaw {

/// A constraint on the line, as nearly as can be seen.
struct ProfileMark {
  double along = 0;  ///< the foot of its perpendicular, from the line's start, scene units
  double value = 0;  ///< that it asks for
  ConstraintKind kind = ConstraintKind::boundary;
  bool normal = false;  ///< a boundary constraint's normal constraint
  bool highlight = false;
};

struct ProfileData {
  double length = 0;  ///< of the line, scene units
  Values along;       ///< N, from 0 to length
  Values values;      ///< f there, N; not a number where f is none
  Values other;       ///< of the other function there, N, or none
  std::vector<ProfileMark> marks;

  bool empty() const { return along.size() == 0; }
  /// f at a distance along the line, linear between samples; not a number beyond its ends.
  double at(double distance) const;
};

/// `near`: how far from the line a constraint may be, scene units. Nothing for a line without length. `other`
/// may be null.
ProfileData profile_of(const Field<2>& field, const ProfileLine& line, const Document<2>& document,
                       const Field<2>* other, double near, Index samples = 257);

/// The ends of the value axis. Zero is always between them.
class ProfileRange {
 public:
  /// Grows where the profile, its marks or the other function leave it.
  void include(const ProfileData& profile);
  /// When all is at rest: include(), anew where the profile needs less than a third of the axis.
  void settle(const ProfileData& profile);
  /// The next include() chooses it anew.
  void reset() { low_ = high_ = 0; }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double low_ = 0, high_ = 0;
};

struct ProfileLook {
  double text_size = 10;  ///< of numbers and words, the canvas' unit; lines and symbols follow
  UiColors colors = ui_colors(false);
};

void draw_profile(Canvas& canvas, const Rect& region, const ProfileData& profile, const ProfileRange& range,
                  const ProfileLook& look = {});

}  // namespace seesaw
