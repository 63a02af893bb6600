// The shortest paths along edges, by graphology: dijkstra.js MESH SOURCE DISTANCES
// It reports no time of its own: its process is timed, less one that reads the mesh.
const fs = require('fs');
const Graph = require('graphology');
const {dijkstra} = require('graphology-shortest-path');

const [mesh, source, distances] = process.argv.slice(2);
const lines = fs.readFileSync(mesh, 'ascii').split('\n').map(line => line.split(' '));
const points = lines.filter(words => words[0] === 'v').map(words => words.slice(1, 4).map(Number));
const faces = lines.filter(words => words[0] === 'f').map(words => words.slice(1, 4).map(v => v - 1));
if (source !== '') {
  const length = (a, b) => Math.hypot(...points[a].map((x, i) => x - points[b][i]));
  const graph = new Graph({type: 'undirected'});
  points.forEach((_, v) => graph.addNode(v));
  for (const [a, b, c] of faces) {
    for (const [from, to] of [[a, b], [b, c], [c, a]]) {
      if (!graph.hasEdge(from, to)) graph.addEdge(from, to, {length: length(from, to)});
    }
  }
  const paths = dijkstra.singleSource(graph, source, 'length');
  const along = path => path.slice(1).reduce((sum, v, i) => sum + length(path[i], v), 0);
  const text = points.map((_, v) => v in paths ? along(paths[v]) : Infinity).join('\n');
  fs.writeFileSync(distances, text + '\n');
}
