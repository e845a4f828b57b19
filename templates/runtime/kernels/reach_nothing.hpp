// Without certificates nothing is kept of links' accelerations.
template <class T>
struct Reached {};
ADAGEN_INLINE Reached<Value> reached_at(const Workspace&, int) { return {}; }
template <class T>
ADAGEN_INLINE void reach(Workspace&, const Joints<T>&, JointKind, const Motion<T>&, Reached<T>&) {}
ADAGEN_INLINE void keep_reached(Workspace&, std::size_t, const Reached<Value>&) {}
