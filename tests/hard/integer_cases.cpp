#include "tests/hard/integer_cases.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

namespace halfspace::testing {
namespace {

class Builder {
 public:
  Builder(std::int32_t width, std::int32_t height, std::int64_t unit) : unit_(unit) {
    scene_.width = width;
    scene_.height = height;
    scene_.scissor = {0, 0, width - 1, height - 1};
    scene_.lighting = {{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}, {4, -5, -8}, 1, 4, 5};
  }

  IntegerScene build(const std::string& text) {
    std::istringstream in(text);
    std::string word;
    while (in >> word) {
      read(in, word);
      if (!in) throw std::invalid_argument("numbers are missing after '" + word + "'");
    }
    if (eye_ != 0) add_eye_planes();
    return scene_;
  }

 private:
  void read(std::istream& in, const std::string& word) {
    if (word == "light") {
      for (std::int64_t& n : scene_.lighting.light) in >> n;
      in >> scene_.lighting.ambient >> scene_.lighting.parallel >> scene_.lighting.unit;
    } else if (word == "eye") {
      in >> eye_;
      scene_.lighting.normal_matrix = {
          {{unit_ * eye_, 0, 0, 0}, {0, unit_ * eye_, 0, 0}, {middle_x(), middle_y(), 0, 1}}};
    } else if (word == "body") {
      add_body(in);
    } else {
      add_half_space(in, word);
    }
  }

  [[nodiscard]] std::int64_t middle_x() const { return scene_.width / 2; }
  [[nodiscard]] std::int64_t middle_y() const { return scene_.height / 2; }

  void add_body(std::istream& in) {
    IntegerBody& body = scene_.bodies.emplace_back();
    for (std::int64_t& n : body.origin) {
      in >> n;
      n *= unit_;
    }
    body.origin[0] += middle_x();
    body.origin[1] += middle_y();
    body.x1 = scene_.width - 1;
    body.y1 = scene_.height - 1;
  }

  void add_half_space(std::istream& in, const std::string& word) {
    const std::size_t marks = word.find('!');
    const std::string kind = word.substr(0, std::min(marks, word.find("=t")));
    IntegerHalfSpace h;
    h.complement = marks != std::string::npos;
    h.transparent = word.find("=t") != std::string::npos;
    h.kind = kind == "plane" ? HalfSpaceKind::plane : HalfSpaceKind::quadric;
    if (kind == "sphere") {
      read_sphere(in, h);
    } else if (kind == "plane" || kind == "quadric") {
      for (std::size_t i = 0; i < (kind == "plane" ? 4 : 10); ++i) in >> h.c[i];
    } else {
      throw std::invalid_argument("'" + word + "' is no word of an integer case");
    }
    if (scene_.bodies.empty()) throw std::invalid_argument("a half-space stands before the first body");
    if (eye_ != 0) project(h);
    scale(h);
    h.name = kind + std::to_string(scene_.bodies.back().half_spaces.size());
    scene_.bodies.back().half_spaces.push_back(h);
  }

  static void read_sphere(std::istream& in, IntegerHalfSpace& h) {
    std::array<mpz_class, 3> centre;
    mpz_class radius_squared;
    for (mpz_class& n : centre) in >> n;
    in >> radius_squared;
    h.c = {1, 1, 1, 0, 0, 0, -centre[0], -centre[1], -centre[2], 0};
    h.c[9] = centre[0] * centre[0] + centre[1] * centre[1] + centre[2] * centre[2] - radius_squared;
  }

  // From (x, y, w) to X = f x / w, Y = f y / w, Z = -f^2 / w: the value is multiplied by -Z or Z^2.
  void project(IntegerHalfSpace& h) const {
    const mpz_class f = eye_, f2 = f * f;
    const std::array<mpz_class, 10> c = h.c;
    if (h.kind == HalfSpaceKind::plane) {
      h.c = {c[0] * f, c[1] * f, -c[3], c[2] * f2};
    } else {
      h.c = {c[0] * f2, c[1] * f2,     c[9],          c[3] * f2,  -c[7] * f,
             -c[6] * f, c[5] * f2 * f, c[4] * f2 * f, -c[8] * f2, c[2] * f2 * f2};
    }
  }

  void scale(IntegerHalfSpace& h) const {
    const mpz_class k = unit_;
    if (h.kind == HalfSpaceKind::plane) {
      h.c[3] *= k;
      return;
    }
    for (std::size_t i : {6, 7, 8}) h.c[i] *= k;
    h.c[9] *= k * k;
  }

  void add_eye_planes() {
    IntegerHalfSpace eye;
    eye.c = {0, 0, 1, 0};
    eye.transparent = true;
    eye.name = "eye plane";
    for (IntegerBody& body : scene_.bodies) body.half_spaces.push_back(eye);
  }

  IntegerScene scene_;
  std::int64_t unit_;
  long eye_ = 0;
};

// The page shows -16 .. 15 units each way.
std::vector<IntegerCase> table() {
  return {
      {"tangent_sphere_and_plane",
       "body 0 0 0 sphere 0 0 0 100 plane 1 0 0 -10 plane 0 0 -1 -10 "
       "body 1 0 0 sphere 0 0 0 100 plane -1 0 0 10 "
       "body 0 0 0 plane 0 -1 0 10 plane 0 1 0 -12 plane 0 0 -1 -5"},
      {"spheres_tangent_outside",
       "body -6 0 0 sphere 0 0 0 36 body 6 0 0 sphere 0 0 0 36 body -6 0 7 sphere 0 0 4 25 body 0 8 0 sphere 0 0 0 16"},
      {"spheres_tangent_outside_one_body",
       "body 0 0 0 sphere -6 0 0 36 sphere 6 0 0 36 body 0 3 0 sphere 0 0 0 36 sphere! 6 8 0 16 "
       "body 0 -9 0 sphere 0 0 0 25 sphere! 0 0 -10 25"},
      {"spheres_tangent_inside", "body 0 0 0 sphere 0 0 0 144 body 0 0 -4 sphere 0 0 0 64 body 5 0 0 sphere 0 0 0 49"},
      {"spheres_tangent_inside_one_body",
       "body -7 0 0 sphere 0 0 0 64 sphere! 3 0 0 25 plane 0 0 -1 0 body 8 0 0 sphere 0 0 0 49 sphere! 0 0 -3 16"},
      {"equal_spheres_a_hair_apart",
       "body 0 0 0 quadric 1000000000 1000000000 1000000000 0 0 0 0 0 0 -100000000000 "
       "body 0 0 0 quadric 1000000000 1000000000 1000000000 0 0 0 -1 0 0 -100000000000 "
       "body 0 0 0 quadric 1000000000 1000000000 1000000000 0 0 0 0 0 1 -100000000000"},
      {"equal_spheres_a_hair_apart_one_body",
       "body -8 0 0 quadric 1000000000 1000000000 1000000000 0 0 0 0 0 0 -49000000000 "
       "quadric 1000000000 1000000000 1000000000 0 0 0 -1 0 0 -49000000000 "
       "body 8 0 0 quadric 1000000000 1000000000 1000000000 0 0 0 0 0 0 -49000000000 "
       "quadric! 1000000000 1000000000 1000000000 0 0 0 -1 0 1 -49000000000"},
      {"plane_through_cone_apex",
       "body -8 0 0 quadric 4 -1 4 0 0 0 0 0 0 0 plane 0 1 0 -12 plane 1 0 0 0 plane 0 -1 0 0 "
       "body 8 0 0 quadric 4 -1 4 0 0 0 0 0 0 0 plane 0 1 0 -12 plane 0 -1 0 -12 plane 2 1 0 0 "
       "body 0 12 0 quadric 1 1 -4 0 0 0 0 0 0 0 plane 0 0 1 0 plane 0 0 -1 -6 plane 1 2 1 0"},
      {"cone_apex_inside_body",
       "body -8 0 0 quadric 4 -1 4 0 0 0 0 0 0 0 plane 0 1 0 -12 plane 0 -1 0 -12 "
       "body 8 0 0 quadric! 1 1 -1 0 0 0 0 0 0 0 plane 1 0 0 -6 plane -1 0 0 -6 plane 0 1 0 -9 plane 0 -1 0 -9 "
       "plane 0 0 -1 -5 plane 0 0 1 -5"},
      {"cone_apex_inside_ball", "body 0 0 0 sphere 0 0 0 169 quadric! 1 -1 1 0 0 0 0 0 0 0"},
      {"cone_apex_on_ball",
       "body -8 0 0 sphere 0 0 0 49 quadric! 4 -1 4 0 0 0 0 -7 0 -49 body 8 0 0 sphere 0 0 0 49 quadric 1 1 -1 0 0 0 0 "
       "0 "
       "-7 -49"},
      {"limb_plane_is_cutting_plane",
       "body -8 0 0 quadric 1 0 1 0 0 0 0 0 0 -36 plane 0 0 1 0 plane 0 1 0 -12 plane 0 -1 0 -12 plane 1 0 0 -6 "
       "body 8 0 0 sphere 0 0 0 49 plane 0 0 -1 0 plane 1 0 0 -7 body 8 11 0 quadric 4 -1 4 0 0 0 0 0 0 0 plane 0 0 1 "
       "0 "
       "plane "
       "0 1 0 -4 plane 2 1 0 0 plane 0 -1 0 -4"},
      {"limb_plane_is_cutting_plane_turned",
       "body -8 0 0 quadric 1 0 2 0 0 1 0 0 0 -36 plane 0 0 0 0 plane 0 1 0 -12 plane 0 -1 0 -12 plane 0 0 2 0 "
       "body 8 0 0 quadric 3 2 1 0 1 1 0 0 0 -49 plane 1 1 1 0"},
      {"cylinder_along_view",
       "body -8 0 0 quadric 1 1 0 0 0 0 0 0 0 -49 plane 1 2 -4 0 plane 0 0 1 -9 "
       "body 8 0 0 quadric 1 1 0 0 0 0 0 0 0 -49 quadric! 1 1 0 0 0 0 0 0 0 -25 plane 1 2 -4 0 plane 0 0 1 -9"},
      {"cylinder_a_hair_off_view",
       "body -8 0 0 quadric 1000000000000 1000000000000 5 0 -2000000 -1000000 0 0 0 -49000000000000 plane 1 2 -4 0 "
       "plane "
       "0 0 1 "
       "-9 body 8 0 0 quadric 1000000000000 1000000000000 5 0 -2000000 -1000000 0 0 0 -49000000000000 "
       "quadric! 1000000000000 1000000000000 5 0 -2000000 -1000000 0 0 0 -25000000000000 plane 1 2 -4 0 plane 0 0 1 "
       "-9000000"},
      {"paraboloid_along_view",
       "body -8 0 0 quadric 1 1 0 0 0 0 0 0 -2 0 plane 0 0 1 -12 body 8 0 0 quadric 1 1 0 0 0 0 0 0 2 -49 plane 0 0 -1 "
       "-12 "
       "body 0 0 20 quadric 0 0 0 1 0 0 0 0 -5 0 plane 0 0 1 -9"},
      {"hyperboloid_cut_between_sheets",
       "body -8 0 0 quadric 1 1 -1 0 0 0 0 0 0 9 plane 0 0 -1 0 plane 0 0 1 -8 "
       "body 8 0 0 quadric 4 -1 4 0 0 0 0 0 0 16 plane 0 1 0 -12 plane 0 -1 0 -12 plane 0 0 1 0 "
       "body 0 0 0 quadric 4 -1 4 0 0 0 0 0 0 16 plane 0 1 0 -9 plane 0 -1 0 4"},
      {"hyperboloid_cut_between_sheets_turned",
       "body 0 0 0 quadric 2 -2 3 1 -1 2 0 0 0 9 plane 1 2 -1 0 plane 0 1 0 -12 body 0 0 0 quadric 2 -2 3 1 -1 2 0 0 0 "
       "9 "
       "plane "
       "-1 -2 1 0 plane 0 -1 0 -12 plane 1 1 0 0"},
      {"steinmetz_2", "body 0 0 0 quadric 0 1 1 0 0 0 0 0 0 -100 quadric 1 0 1 0 0 0 0 0 0 -100"},
      {"steinmetz_3",
       "body 0 0 0 quadric 0 1 1 0 0 0 0 0 0 -100 quadric 1 0 1 0 0 0 0 0 0 -100 quadric 1 1 0 0 0 0 0 0 0 -100"},
      {"steinmetz_6",
       "body 0 0 0 quadric 1 1 2 -1 0 0 0 0 0 -200 quadric 1 1 2 1 0 0 0 0 0 -200 quadric 2 1 1 0 -1 0 0 0 0 -200 "
       "quadric 2 1 1 0 1 0 0 0 0 -200 quadric 1 2 1 0 0 -1 0 0 0 -200 quadric 1 2 1 0 0 1 0 0 0 -200"},
      {"four_planes_in_a_point",
       "body -8 0 0 plane 2 -1 0 -10 plane -2 -1 0 -10 plane 0 -1 2 -10 plane 0 -1 -2 -10 plane 0 1 0 -8 "
       "body 8 0 0 plane 2 0 -1 -5 plane -2 0 -1 -5 plane 0 2 -1 -5 plane 0 -3 -1 -5 plane 0 0 1 -8"},
      {"twelve_planes_in_a_point",
       "body -8 0 0 plane 10 -5 0 -50 plane 8 -5 6 -50 plane 6 -5 8 -50 plane 0 -5 10 -50 plane -6 -5 8 -50 plane -8 "
       "-5 "
       "6 -50 "
       "plane -10 -5 0 -50 plane -8 -5 -6 -50 plane -6 -5 -8 -50 plane 0 -5 -10 -50 plane 6 -5 -8 -50 plane 8 -5 -6 "
       "-50 "
       "plane 0 1 0 -4 "
       "body 8 0 0 plane 10 0 -5 -50 plane 8 6 -5 -50 plane 6 8 -5 -50 plane 0 10 -5 -50 plane -6 8 -5 -50 plane -8 6 "
       "-5 "
       "-50 "
       "plane -10 0 -5 -50 plane -8 -6 -5 -50 plane -6 -8 -5 -50 plane 0 -10 -5 -50 plane 6 -8 -5 -50 plane 8 -6 -5 "
       "-50 "
       "plane 0 0 1 -4"},
      {"coincident_faces",
       "body 0 0 0 plane 1 0 0 0 plane -1 0 0 -10 plane 0 1 0 -8 plane 0 -1 0 -8 plane 0 0 -1 -5 plane 0 0 1 -5 "
       "body 0 0 0 plane! 1 0 0 0 plane 1 0 0 -10 plane 0 1 0 -8 plane 0 -1 0 -8 plane 0 0 -3 -15 plane 0 0 1 -5 "
       "body 0 0 1 sphere 0 0 0 81 plane 0 1 0 0 body 0 0 0 quadric 2 2 2 0 0 0 0 0 -2 -160"},
      {"redundant_intersections",
       "body 0 0 0 plane 1 0 0 -9 plane 1 0 0 -9 plane -1 0 0 -9 plane 0 1 0 -9 plane 0 -1 0 -9 plane 0 0 -1 -9 plane "
       "0 "
       "0 1 -9 "
       "plane 1 0 0 -90 plane 1 1 0 -18 plane 1 1 -1 -27 quadric! 1 1 0 0 0 0 0 0 0 -25 sphere 0 0 0 900 "
       "body 0 0 0 sphere 0 0 0 16 sphere 0 0 0 16 plane 1 0 0 -4"},
      {"pair_of_planes",
       "body -8 0 0 quadric 1 -1 0 0 0 0 0 0 0 0 plane 1 0 0 -7 plane -1 0 0 -7 plane 0 1 0 -9 plane 0 -1 0 -9 plane 0 "
       "0 "
       "-1 -5 "
       "body 8 0 0 quadric 2 0 -1 0 0 0 0 0 0 0 plane 1 0 0 -7 plane -1 0 0 -7 plane 0 1 0 -9 plane 0 -1 0 -9 plane 0 "
       "0 "
       "-1 -5 "
       "plane 0 0 1 -5 body 0 0 9 quadric 4 1 1 2 1 2 0 0 0 -16 plane 1 0 0 -9 plane -1 0 0 -9 "
       "body 0 0 30 quadric 0 0 0 0 1 0 0 0 0 0 plane 0 0 1 -9"},
      {"double_plane",
       "body 0 0 0 quadric 1 4 1 2 -2 -1 0 0 0 0 plane 1 0 0 -9 plane -1 0 0 -9 plane 0 1 0 -9 plane 0 -1 0 -9 "
       "body 3 0 0 quadric 1 0 0 0 0 0 0 0 0 0 plane 0 1 0 -9 body 0 0 9 quadric 0 0 1 0 0 0 0 0 0 0 plane 1 2 0 0"},
      {"line_quadric",
       "body 0 3 0 quadric 0 1 1 0 0 0 0 0 0 0 plane 1 0 0 -9 plane -1 0 0 -9 body 5 5 0 quadric 1 1 0 0 0 0 0 0 0 0 "
       "plane 0 0 "
       "-1 -4 body 0 0 0 quadric 1 1 2 0 -1 -1 0 0 0 0 plane 0 0 1 -9 plane 0 0 -1 -9 "
       "body -6 0 0 quadric 1 0 1 0 0 0 0 0 0 0 plane 0 1 0 -9"},
      {"point_quadric",
       "body 0 0 0 sphere 0 0 0 0 body -4 0 0 quadric 1 2 3 0 0 0 0 0 0 0 "
       "body 0 0 0 sphere! 0 0 -5 0 plane 1 0 0 -9 plane -1 0 0 -9 plane 0 1 0 -9 plane 0 -1 0 -9 plane 0 0 -1 -5"},
      {"empty_quadric",
       "body 0 0 0 sphere 0 0 0 -1 body 0 0 0 plane 1 0 0 -9 quadric 1 0 1 0 0 0 0 0 0 1 quadric 0 1 0 0 0 0 0 0 0 1 "
       "body 0 0 0 sphere! 0 0 0 -1 quadric! 1 0 1 0 0 0 0 0 0 1 quadric! 0 1 0 0 0 0 0 0 0 1 plane 1 0 0 -9 plane -1 "
       "2 "
       "0 -9 "
       "plane 0 -1 0 -9 plane 1 2 -4 -9"},
      {"quadric_without_second_order",
       "body 0 0 0 quadric 0 0 0 0 0 0 1 2 -3 -5 plane 1 0 0 -9 plane -1 0 0 -9 plane 0 1 0 -9 plane 0 -1 0 -9 "
       "plane 0 0 1 -40 body 0 0 9 quadric 1 0 0 0 0 0 1000000000000 1000000000000 -1000000000000 -1 "
       "body 0 0 0 quadric 0 0 0 0 0 0 1 1 0 20 plane 0 0 -1 0 body 0 0 40 quadric 0 0 0 0 0 0 0 0 0 -1 plane 0 1 -1 "
       "0"},
      {"needle_ellipsoid",
       "body 0 0 5 quadric 1000000000000 1 1000000000000 0 0 0 0 0 0 -25000000000000 "
       "body 0 0 0 quadric 1 1000000000000 1000000000000 0 0 0 0 0 0 -144 "
       "body 0 8 0 quadric 1 1000000000000 1000000000000 0 0 0 -5 0 0 0"},
      {"needle_ellipsoid_along_view",
       "body -8 0 0 quadric 1000000000000 1000000000000 1 0 0 0 0 0 0 -49000000000000 "
       "body 8 0 0 quadric 1000000000000 1000000000000 6 0 -2000000 -1000000 0 0 0 -49000000000000"},
      {"disc_ellipsoid",
       "body -8 0 0 quadric 1 1 1000000000000 0 0 0 0 0 0 -49 body 8 0 0 quadric 1 1000000000000 1 0 0 0 0 0 0 -49 "
       "body 0 0 20 quadric 1 1 1000000000000 0 0 0 0 0 1000000000000 0"},
      {"sphere_of_radius_1e9_dots",
       "body 0 0 0 quadric 1 1 1 0 0 0 -1000000000 0 0 0 body 0 0 3 quadric 1 1 1 0 0 0 0 0 -1000000000 0 plane 0 -1 0 "
       "4 "
       "body 0 0 0 quadric! 1 1 1 0 0 0 2000000000 2000000000 1000000000 0 plane 1 0 0 5 plane 0 0 -1 -9"},
      {"body_1e7_dots_off_the_page",
       "body 0 0 0 sphere 10000000 0 0 25 body -8 0 -10000000 sphere 0 0 0 36 body 8 0 10000000 sphere 0 0 0 36 "
       "body 0 0 0 sphere -10000000 -10000000 0 9 "
       "body 0 8 0 quadric 0 1 1 0 0 0 0 0 0 -25 plane 1 0 0 -10000000 plane -1 0 0 -8"},
      {"thinner_than_a_dot",
       "body -12 0 0 plane 1000 0 0 -1 plane -1 0 0 0 plane 0 1 0 -9 body -10 0 0 plane 1000 0 0 -2 plane -1000 0 0 1 "
       "plane 0 1 0 -9 body -6 0 0 quadric 1000000 0 1000000 0 0 0 0 0 0 -1 plane 0 1 0 -9 "
       "body -4 0 0 quadric 1000000 0 1000000 0 0 0 -1000 0 0 999999 plane 0 1 0 -9 plane 1 1 -9 -5 "
       "body 6 0 0 quadric 1000000 1000000 1000000 0 0 0 0 0 0 -49000000 quadric! 1000000 1000000 1000000 0 0 0 0 0 0 "
       "-48999999 "
       "plane 1 2 -10 0 body 0 12 0 plane 10000 0 0 -1 plane 0 -1 0 0 body 0 12 0 plane -10000 0 0 2 plane 0 -1 0 0"},
      {"one_dot_page",
       "body 0 0 0 sphere 0 0 0 100 plane 1 1 1 0 body 0 0 0 quadric 4 -1 4 0 0 0 0 0 0 0 plane 0 1 0 -15"},
      {"eye_inside_body",
       "eye 16 body 0 0 0 sphere 0 0 4 400 plane 0 0 1 -14 body 0 0 0 quadric 1 1 0 0 0 0 0 0 0 -25 plane 0 1 1 -40 "
       "body 0 0 0 quadric 1 4 -1 0 0 0 0 0 0 -100 plane 0 0 1 -90"},
      {"eye_inside_hollow_body",
       "eye 16 body 0 0 0 sphere 0 0 4 1600 sphere! 0 0 4 1225 plane 0 1 -1 -20 body 0 0 0 sphere 2 1 16 25 "
       "body 0 0 0 sphere! 0 0 0 100 plane 1 0 0 -4"},
      {"faces_across_the_eye_plane",
       "eye 16 body 0 0 0 quadric 1 1 0 0 0 0 6 6 0 56 body 0 0 0 sphere 12 0 0 121 body 0 0 0 plane 0 -1 0 5 plane 0 "
       "1 "
       "0 -9 "
       "body 0 0 0 quadric 4 4 -1 0 0 0 0 0 4 -16 plane 0 1 0 4"},
      {"near_w_zero",
       "eye 16 body 0 0 0 sphere 0 6 0 36 body 0 0 0 sphere 0 -7 0 48 body 0 0 0 quadric 1 1 -1 0 0 0 4 0 0 16 plane 1 "
       "0 "
       "0 3 "
       "body 0 0 0 plane 0 0 1 -1 plane 1 0 0 -5 plane -1 0 0 5 body 0 0 0 plane 1 1 0 0 plane 0 0 1 -9"},
      {"light_along_view",
       "light 0 0 -1 1 9 10 body -8 -6 0 sphere 0 0 0 36 body 8 0 0 quadric 1 0 1 0 0 0 0 0 0 -25 plane 0 1 0 -12 "
       "plane 0 -1 0 -12 body -8 8 0 quadric 1 1 -1 0 0 0 0 0 0 0 plane 0 0 1 -6 plane 0 0 -1 0"},
      {"light_grazing",
       "light 0 -1 0 1 9 10 body -8 -6 0 sphere 0 0 0 36 body 8 0 0 quadric 1 0 1 0 0 0 0 0 0 -25 plane 0 1 0 -12 "
       "plane 0 -1 0 -12 body -8 8 0 quadric 1 1 -1 0 0 0 0 0 0 0 plane 0 0 1 -6 plane 0 0 -1 0 body 0 0 9 plane 1 0 "
       "-1 "
       "0"},
      {"light_behind",
       "light 1 -2 9 1 9 10 body -8 -6 0 sphere 0 0 0 36 body 8 0 0 quadric 1 0 1 0 0 0 0 0 0 -25 plane 0 1 0 -12 "
       "plane 0 -1 0 -12 body -8 8 0 quadric 1 1 -1 0 0 0 0 0 0 0 plane 0 0 1 -6 plane 0 0 -1 0 "
       "body 0 6 0 quadric! 1 1 1 0 0 0 0 0 0 -100 plane -1 1 0 -3 plane 0 0 1 -8"},
      // The light is at 3, 4, 5, and so is the cone of normals of a threshold: its top and bottom are 24/25 of the radius up, and 0.
      {"contours_tangent_to_scan_line",
       "light 0 -3 -4 0 5 8 body 0 16 0 sphere 0 0 0 625 body 0 -24 0 sphere 0 0 0 625 body 0 0 99 quadric 1 4 4 0 0 0 "
       "0 "
       "0 0 -2500"},
      {"contours_born_between_lines",
       "light 3 -10 -1000 1 49 50 body -9 -9 0 sphere 0 0 0 4 body -9 5 0 quadric 9 1 1 0 0 0 0 0 0 -36 "
       "body 6 -4 0 quadric 1 40 1 0 0 0 0 0 0 -64 body 5 8 0 quadric 1 1 0 0 0 0 0 0 -2 -1 plane 0 0 1 -12 "
       "body 12 8 0 quadric 40 40 40 0 0 0 -20 -20 0 0"},
      {"viviani",
       "body 0 0 0 sphere 0 0 0 144 quadric 1 0 1 0 0 0 -6 0 0 0 "
       "body 0 0 0 sphere 0 0 0 144 quadric! 1 0 1 0 0 0 -6 0 0 0 plane 1 0 0 -1"},
      {"unequal_cylinders",
       "body 0 0 0 quadric 0 1 1 0 0 0 0 0 0 -100 quadric 100000 0 100000 0 0 0 0 0 0 -9999999 quadric 1 1 0 0 0 0 0 0 "
       "0 "
       "-100 "
       "quadric! 0 2 2 0 -1 0 0 0 0 -9"},
      {"eight_quadrics",
       "body 0 0 0 sphere 0 0 0 144 quadric 0 1 1 0 0 0 0 0 0 -100 quadric 1 0 1 0 0 0 0 0 0 -110 quadric 10 5 5 1 0 0 "
       "0 "
       "0 0 -700 "
       "quadric 1 1 0 0 0 0 0 0 -5 -100 quadric 2 -1 2 0 0 0 0 0 0 -150 sphere! 2 -4 -10 25 quadric! 3 3 -1 0 0 0 9 9 "
       "0 "
       "54"},
      {"cones_with_one_apex",
       "body 0 0 0 sphere 0 0 0 169 quadric! 2 -1 1 0 0 0 0 0 0 0 quadric 1 -1 2 0 0 0 0 0 0 0 "
       "body 0 0 -20 quadric 1 1 -4 0 0 0 0 0 0 0 quadric 4 1 -4 0 0 0 0 0 0 0 plane 0 0 1 -6 plane 0 0 -1 -2"},
      {"quadrics_that_touch_along_curves",
       "body -9 0 0 quadric 1 0 1 0 0 0 0 0 0 -36 sphere! 0 0 0 36 plane 0 1 0 -8 plane 0 -1 0 -8 plane 0 0 -1 0 "
       "body 0 -2 0 quadric 4 1 4 0 0 0 0 0 0 -100 sphere! 0 0 0 25 plane 1 0 -1 0 "
       "body 9 5 0 quadric 1 -1 1 0 0 0 0 0 0 0 sphere 0 8 0 32 body 9 -9 0 sphere 0 0 0 25 quadric! 1 1 0 0 0 0 0 0 0 "
       "-25"},
      {"quadrics_with_a_common_ruling",
       "body -8 0 0 quadric 1 1 0 0 0 0 -6 0 0 0 quadric 1 0 0 0 -1 0 0 0 0 0 plane 0 0 -1 -9 plane 0 0 1 -9 "
       "body 8 0 0 quadric 1 0 1 0 0 0 6 0 0 0 quadric! 1 0 1 0 0 0 3 0 0 0 plane 0 1 0 -9 plane 0 -1 0 -9 "
       "body 0 0 9 quadric 0 0 0 1 0 0 0 0 -2 0 quadric 0 0 0 0 1 0 -2 0 0 0 plane 0 0 -1 -9 plane 0 0 1 -9"},
      {"meeting_along_view",
       "body -8 0 0 quadric 1 1 0 0 0 0 3 0 0 -16 quadric 1 1 0 0 0 0 -3 0 0 -16 plane 1 2 -4 0 plane 0 0 1 -9 "
       "body 8 0 0 sphere 0 0 0 49 quadric 1 1 0 0 0 0 0 0 -1 -23"},
      {"spheres_that_osculate_an_ellipsoid",
       "body 0 0 0 quadric 1 4 4 0 0 0 0 0 0 -144 sphere! 9 0 0 9 sphere! 0 0 0 36 plane 0 0 -1 0 "
       "body 0 12 0 quadric 1 4 4 0 0 0 0 0 0 -16 sphere 3 0 0 1"},
      {"narrow_far_parabola",
       "body 0 0 0 quadric 1 1 1000000 0 0 0 0 0 -1000000000000 999999999999999936 "
       "body -5 -5 0 quadric 1000000 1000000 1000000 0 0 0 0 0 -1000000000000 999999999991000000 "
       "body 5 -5 0 sphere 0 0 1000000000 25"},
      {"narrow_far_parabola_on_the_page",
       "body 0 0 0 quadric 1000000 0 0 0 0 0 0 5 0 -100000 plane 0 0 1 0 body -5 0 0 quadric 1000000 0 0 0 0 0 -500000 "
       "5 "
       "0 150000 "
       "plane 0 0 1 0 body 8 0 0 quadric 400 0 400 0 0 0 0 5 0 -10000000"},
  };
}

}  // namespace

const std::vector<IntegerCase>& integer_cases() {
  static const std::vector<IntegerCase> cases = table();
  return cases;
}

IntegerScene integer_scene(const IntegerCase& item, std::int32_t width, std::int32_t height, std::int64_t unit) {
  return Builder(width, height, unit).build(item.text);
}

}  // namespace halfspace::testing
