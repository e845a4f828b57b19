// Robots as pinocchio's programs read them. Included behind an algorithm of pinocchio.

namespace {

using Vector = Eigen::VectorXd;

// One joint a line: kind, parent, rotation, translation; mass, centre of mass, inertia about it.
pinocchio::Model read_model(const char* path) {
  std::ifstream file(path);
  pinocchio::Model model;
  const auto vector = [&file] {
    Eigen::Vector3d x;
    file >> x[0] >> x[1] >> x[2];
    return x;
  };
  const auto matrix = [&vector] {
    Eigen::Matrix3d rows;
    for (int k = 0; k < 3; ++k) rows.row(k) = vector().transpose();
    return rows;
  };
  model.gravity.linear() = vector();
  std::string kind;
  while (file >> kind) {
    pinocchio::JointIndex parent;
    double mass;
    file >> parent;
    const Eigen::Matrix3d turn = matrix();
    const pinocchio::SE3 place(turn, vector());
    file >> mass;
    const Eigen::Vector3d centre = vector();
    const pinocchio::Inertia inertia(mass, centre, matrix());
    const std::string name = "j" + std::to_string(model.njoints);
    pinocchio::JointIndex joint = 0;
    if (kind == "revolute")
      joint = model.addJoint(parent, pinocchio::JointModelRZ(), place, name);
    else if (kind == "prismatic")
      joint = model.addJoint(parent, pinocchio::JointModelPZ(), place, name);
    else if (kind == "spherical")
      joint = model.addJoint(parent, pinocchio::JointModelSpherical(), place, name);
    else if (kind == "planar")
      joint = model.addJoint(parent, pinocchio::JointModelPlanar(), place, name);
    else if (kind == "floating")
      joint = model.addJoint(parent, pinocchio::JointModelFreeFlyer(), place, name);
    else
      measure::fail("unknown kind of joint " + kind);
    model.appendBodyToJoint(joint, inertia, pinocchio::SE3::Identity());
  }
  return model;
}

std::vector<Vector> rows(const std::vector<double>& all, long count, long width) {
  std::vector<Vector> found;
  for (long s = 0; s < count; ++s)
    found.push_back(Eigen::Map<const Vector>(all.data() + s * width, width));
  return found;
}

}  // namespace
