package org.hdispatch.bench.paper;

import java.util.List;
import org.hdispatch.cell.CellGrid;
import org.hdispatch.cell.CellKey;
import org.hdispatch.cell.CellMap;
import org.hdispatch.cell.Ends;
import org.hdispatch.cell.KeyOrder;
import org.hdispatch.dispatch.Pass;
import org.hdispatch.dispatch.Scheme;
import org.hdispatch.dispatch.Tick;
import org.hdispatch.lbm.BodyForce;
import org.hdispatch.lbm.BundleSize;
import org.hdispatch.lbm.Collision;
import org.hdispatch.lbm.CollisionKernel;
import org.hdispatch.lbm.KernelForm;
import org.hdispatch.lbm.Lattice;
import org.hdispatch.lbm.LbmScheme;
import org.hdispatch.lbm.Streaming;
import org.hdispatch.lbm.VelocitySet;

/**
 * The lattice Boltzmann method on a dictionary of bundles which are dictionaries of nodes. Every
 * neighbour is looked up by its key in every step, and collided node by node with the library's
 * {@link KernelForm#REFERENCE} kernel: same collision, same dispatcher, same bits as {@link
 * LbmScheme}; only the layout differs.
 *
 * <p>Each peer in its best form: the key of a node is its position in the bundle, so that the hash
 * map of a bundle has no collisions and is walked through in the order of memory; the dictionary of
 * bundles is asked only for neighbours that lie outside.
 *
 * <p>Walls stand where there is no node. (Unlike {@link LbmScheme}'s, they let fluid slip through
 * the edge where two solid nodes touch; a duct has none.)
 */
final class NodeScheme implements Scheme<NodeBundle, NodeScheme.Scratch> {
  private final Lattice lattice;
  private final Collision collision;
  private final VelocitySet set;
  private final BundleSize size;
  private final Streaming streaming;
  private final CellMap<NodeBundle> cells; // what the dispatcher hands out
  private final Dictionary<NodeBundle> bundles; // where neighbours are looked up
  private final Scratch scratch; // the caller's
  private int previous; // copy that holds the populations

  /**
   * Makes the nodes, at rest.
   *
   * @throws IllegalArgumentException if {@code streaming} is in place
   */
  NodeScheme(
      Lattice lattice,
      Collision collision,
      BundleSize bundle,
      Streaming streaming,
      NodeLayout layout) {
    if (streaming == Streaming.IN_PLACE) {
      throw new IllegalArgumentException(
          "nodes must be streamed by pull or push: streaming=" + streaming);
    }
    this.lattice = lattice;
    this.collision = collision;
    this.streaming = streaming;
    set = collision.set();
    size =
        new BundleSize(
            Math.min(bundle.nx(), lattice.nx()),
            Math.min(bundle.ny(), lattice.ny()),
            Math.min(bundle.nz(), lattice.nz()));
    long[] keys =
        CellGrid.of(
                pieces(lattice.nx(), size.nx()),
                pieces(lattice.ny(), size.ny()),
                pieces(lattice.nz(), size.nz()),
                Ends.OPEN)
            .keys();
    cells =
        CellMap.fixed(
            keys,
            KeyOrder.MORTON,
            key ->
                new NodeBundle(
                    CellKey.i(key) * size.nx(),
                    CellKey.j(key) * size.ny(),
                    CellKey.k(key) * size.nz(),
                    size,
                    lattice,
                    layout,
                    set.size()));
    bundles = layout.dictionary(keys, cells::get);
    scratch = newScratch();
    for (int n = 0; n < cells.size(); n++) {
      NodeBundle each = cells.cellAt(n);
      each.nodes.forEach((position, node) -> initialise(each, position, node));
    }
  }

  private static int pieces(int extent, int piece) {
    return (extent + piece - 1) / piece;
  }

  /** Puts a node at rest, which is half-way through the force. */
  private void initialise(NodeBundle bundle, long position, Node node) {
    BodyForce force = collision.force();
    for (int i = 0; i < set.size(); i++) {
      double along = set.cx(i) * force.x() + set.cy(i) * force.y() + set.cz(i) * force.z();
      double rest = collision.equilibrium().deviation(set, i, 1, 0, 0, 0);
      double leaving = rest + set.weight(i) * 3 * along / 2;
      node.set(1, i, 0.0); // every slot holds a number, boxed or not
      if (streaming == Streaming.PULL) {
        node.set(0, i, leaving);
      } else {
        send(bundle, position, node, i, 0, leaving);
      }
    }
  }

  @Override
  public CellMap<NodeBundle> cells() {
    return cells;
  }

  @Override
  public Scratch newScratch() {
    return new Scratch(KernelForm.REFERENCE.kernels().kernel(collision.coefficients()), set.size());
  }

  @Override
  public List<Pass<NodeBundle, Scratch>> passes() {
    String name = streaming == Streaming.PULL ? "pull-collide" : "collide-push";
    return List.of(new Pass<>(name, (bundle, own, tick) -> streamCollide(bundle, own)));
  }

  @Override
  public void afterStep(Tick tick) {
    roll();
  }

  /** Steps on the caller's thread, without the dispatcher. */
  void stepAlone() {
    for (int n = 0; n < cells.size(); n++) {
      streamCollide(cells.cellAt(n), scratch);
    }
    roll();
  }

  private void roll() {
    previous = 1 - previous;
  }

  private void streamCollide(NodeBundle bundle, Scratch own) {
    own.bundle = bundle;
    bundle.nodes.forEach(own);
  }

  /** What a worker needs for a node. */
  final class Scratch implements Dictionary.Visitor<Node> {
    private final CollisionKernel kernel;
    private final double[][] populations;
    private final int[] start;
    private NodeBundle bundle;

    private Scratch(CollisionKernel kernel, int velocities) {
      this.kernel = kernel;
      populations = new double[velocities][1];
      start = new int[velocities];
    }

    @Override
    public void visit(long position, Node node) {
      if (streaming == Streaming.PULL) {
        pullCollide(position, node);
      } else {
        collidePush(position, node);
      }
    }

    private void pullCollide(long position, Node node) {
      int current = 1 - previous;
      for (int i = 0; i < populations.length; i++) {
        Node from = neighbour(bundle, position, node, set.opposite(i));
        populations[i][0] =
            from == null ? node.get(previous, set.opposite(i)) : from.get(previous, i);
      }
      kernel.collide(populations, start, populations, start, 1, 1, 0);
      for (int i = 0; i < populations.length; i++) {
        node.set(current, set.opposite(i), populations[i][0]);
      }
    }

    private void collidePush(long position, Node node) {
      int current = 1 - previous;
      for (int i = 0; i < populations.length; i++) {
        populations[i][0] = node.get(previous, i);
      }
      kernel.collide(populations, start, populations, start, 1, 1, 0);
      for (int i = 0; i < populations.length; i++) {
        send(bundle, position, node, i, current, populations[set.opposite(i)][0]);
      }
    }
  }

  /** Writes what leaves a node along velocity i to where it arrives. */
  private void send(NodeBundle bundle, long position, Node node, int i, int copy, double leaving) {
    Node to = neighbour(bundle, position, node, i);
    if (to == null) {
      node.set(copy, set.opposite(i), leaving);
    } else {
      to.set(copy, i, leaving);
    }
  }

  /** The neighbour of a node along velocity i, or null if a wall stands in between. */
  private Node neighbour(NodeBundle bundle, long position, Node node, int i) {
    if (i == 0) {
      return node;
    }
    int x = bundle.x(position) + set.cx(i);
    int y = bundle.y(position) + set.cy(i);
    int z = bundle.z(position) + set.cz(i);
    if (bundle.holds(x, y, z)) {
      return bundle.node(x, y, z);
    }
    x = lattice.x().wrap(bundle.x0 + x, lattice.nx());
    y = lattice.y().wrap(bundle.y0 + y, lattice.ny());
    z = lattice.z().wrap(bundle.z0 + z, lattice.nz());
    if (x < 0 || y < 0 || z < 0) {
      return null;
    }
    NodeBundle there = bundles.get(CellKey.of(x / size.nx(), y / size.ny(), z / size.nz()));
    return there.node(x % size.nx(), y % size.ny(), z % size.nz());
  }

  /** Visits all nodes as {@link LbmScheme#forEachNode} does, between two steps. */
  void forEachNode(LbmScheme.NodeVisitor visitor) {
    for (int n = 0; n < cells.size(); n++) {
      NodeBundle bundle = cells.cellAt(n);
      bundle.nodes.forEach((position, node) -> visit(bundle, position, node, visitor));
    }
  }

  private void visit(NodeBundle bundle, long position, Node node, LbmScheme.NodeVisitor visitor) {
    double d = leaving(bundle, position, node, 0);
    double jx = -collision.force().x() / 2;
    double jy = -collision.force().y() / 2;
    double jz = -collision.force().z() / 2;
    for (int i = 1; i < set.size(); i += 2) {
      double forth = leaving(bundle, position, node, i);
      double back = leaving(bundle, position, node, i + 1);
      d += forth + back;
      jx += set.cx(i) * (forth - back);
      jy += set.cy(i) * (forth - back);
      jz += set.cz(i) * (forth - back);
    }
    visitor.visit(
        bundle.x0 + bundle.x(position),
        bundle.y0 + bundle.y(position),
        bundle.z0 + bundle.z(position),
        1 + d,
        jx,
        jy,
        jz);
  }

  private double leaving(NodeBundle bundle, long position, Node node, int i) {
    if (streaming == Streaming.PULL) {
      return node.get(previous, i);
    }
    Node to = neighbour(bundle, position, node, i);
    return to == null ? node.get(previous, set.opposite(i)) : to.get(previous, i);
  }

  /** Number of nodes. */
  long nodes() {
    long[] count = new long[1];
    for (int n = 0; n < cells.size(); n++) {
      cells.cellAt(n).nodes.forEach((position, node) -> count[0]++);
    }
    return count[0];
  }
}
