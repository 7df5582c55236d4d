#include "contact_law.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace tribos {

namespace {

const char KEYWORDS[] = "damping, sliding, tangential, coupling, torsion, torsion/spring, rolling, cohesion";

// Numbers after a keyword, one after the other.
class Words {
 public:
  Words(int narg, char **arg, int next, std::string &problem) :
      narg(narg), arg(arg), next(next), problem(problem)
  {
  }

  bool left() const { return next < narg; }
  std::string peek() const { return arg[next]; }
  int index() const { return next; }

  std::string word(const std::string &of, const std::string &valid)
  {
    if (left()) return arg[next++];
    fail("a word is missing after '" + of + "': " + valid);
    return "";
  }

  // A finite number not below 0, or above 0 if `positive`.
  double number(const std::string &of, bool positive)
  {
    const std::string valid = positive ? "a positive number" : "a number of 0 or more";
    if (!left()) {
      fail("a number is missing after '" + of + "': " + valid);
      return 0;
    }
    const char *text = arg[next++];
    char *end = nullptr;
    const double value = std::strtod(text, &end);
    const bool whole = end != text && *end == '\0' && std::isfinite(value);
    if (!whole || (positive ? value <= 0 : value < 0))
      fail("'" + of + " " + text + "': expected " + valid);
    return value;
  }

  void fail(const std::string &what)
  {
    if (problem.empty()) problem = what;
  }

 private:
  int narg;
  char **arg;
  int next;
  std::string &problem;
};

void parse_normal(ContactLaw &law, Words &words)
{
  const std::string valid = "hooke K or hertz E";
  const std::string name = words.word("the types or the fix style", valid);
  if (name == "hooke")
    law.normal = Normal::HOOKE;
  else if (name == "hertz")
    law.normal = Normal::HERTZ;
  else
    words.fail("unknown normal force '" + name + "': expected " + valid);
  law.stiffness = words.number(name, true);
}

void parse_coupling(ContactLaw &law, Words &words)
{
  const std::string valid = "exact, ellipsoid, separate or none";
  const std::string name = words.word("coupling", valid);
  if (name == "none")
    law.coupling = Coupling::NONE;
  else if (name == "separate")
    law.coupling = Coupling::SEPARATE;
  else if (name == "ellipsoid")
    law.coupling = Coupling::ELLIPSOID;
  else if (name == "exact")
    law.coupling = Coupling::EXACT;
  else
    words.fail("unknown coupling '" + name + "': expected " + valid);
}

void parse_torsion_spring(ContactLaw &law, Words &words)
{
  const std::string valid = "area or inertia";
  const std::string name = words.word("torsion/spring", valid);
  if (name == "area")
    law.torsion_spring = TorsionSpring::AREA;
  else if (name == "inertia")
    law.torsion_spring = TorsionSpring::INERTIA;
  else
    words.fail("unknown torsion/spring '" + name + "': expected " + valid);
}

void parse_torsion(ContactLaw &law, Words &words)
{
  law.disk_of_overlap = words.left() && words.peek() == "contact";
  if (law.disk_of_overlap)
    words.word("torsion", "");
  else
    law.mu_torsion = words.number("torsion", false);
}

void parse_keyword(ContactLaw &law, const std::string &key, Words &words)
{
  if (key == "damping")
    law.damping = words.number(key, false);
  else if (key == "sliding")
    law.mu = words.number(key, false);
  else if (key == "tangential")
    law.tangential = words.number(key, true);
  else if (key == "coupling")
    parse_coupling(law, words);
  else if (key == "torsion")
    parse_torsion(law, words);
  else if (key == "torsion/spring")
    parse_torsion_spring(law, words);
  else if (key == "rolling")
    law.mu_rolling = words.number(key, false);
  else if (key == "cohesion") {
    law.cohesion = words.number(key, false);
    law.range = words.number(key + " F", false);
  } else
    words.fail("unknown keyword '" + key + "': expected one of " + KEYWORDS);
}

}    // namespace

int ContactLaw::parse(int narg, char **arg, int first, bool (*ends)(const std::string &),
                      std::string &problem)
{
  Words words(narg, arg, first, problem);
  parse_normal(*this, words);
  while (problem.empty() && words.left() && !ends(words.peek())) {
    const std::string key = words.word("", "");
    parse_keyword(*this, key, words);
  }
  const bool coupled = coupling == Coupling::EXACT || coupling == Coupling::ELLIPSOID;
  if (coupled && !disk_of_overlap && mu_torsion > 0 && mu == 0)
    words.fail("a coupled torsion threshold needs a sliding threshold: give 'sliding' above 0, or 'coupling separate'");
  return words.index();
}

bool operator==(const ContactLaw &a, const ContactLaw &b)
{
  return a.normal == b.normal && a.coupling == b.coupling && a.torsion_spring == b.torsion_spring &&
      a.disk_of_overlap == b.disk_of_overlap && a.stiffness == b.stiffness &&
      a.damping == b.damping && a.tangential == b.tangential && a.mu == b.mu &&
      a.mu_torsion == b.mu_torsion && a.mu_rolling == b.mu_rolling && a.cohesion == b.cohesion &&
      a.range == b.range;
}

}    // namespace tribos
